#include "scenes/scene/named_file.h"

namespace scb::scenes {

namespace fs = std::filesystem;

fs::path named_file(const JsonPlace& place, const SceneContext& context, const std::string& kind,
                    const std::string& remark) {
    const fs::path path = read_plain_text(place);
    const std::string missing = "there is no " + kind + " " + path.string();
    std::error_code ignored;
    if (path.is_absolute()) {
        if (fs::exists(path, ignored)) return path;
        refuse(place, missing + remark + "; check the path.");
    }
    std::string tried;
    for (const fs::path& folder : {context.folder, context.models_dir}) {
        if (folder.empty()) continue;
        if (fs::exists(folder / path, ignored)) return folder / path;
        tried += (tried.empty() ? " in " : " or ") + folder.string();
    }
    refuse(place, missing + tried + remark +
                      "; name the folder that holds it with --models DIR or SCB_MODELS.");
}

}  // namespace scb::scenes
