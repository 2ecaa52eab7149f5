#include "scenes/meshes/left_out.h"

#include <map>
#include <mutex>
#include <utility>

namespace scb::scenes {
namespace {

struct LeftOut {
    std::mutex mutex;
    std::map<std::string, std::vector<std::string>> noted;  ///< by the name of the file
};

LeftOut& left_out() {
    static LeftOut files;
    return files;
}

}  // namespace

void note_left_out(const std::string& file, const std::vector<std::string>& what) {
    if (what.empty()) return;
    const std::lock_guard lock(left_out().mutex);
    left_out().noted.insert_or_assign(file, what);
}

std::vector<std::string> take_left_out() {
    const std::lock_guard lock(left_out().mutex);
    std::vector<std::string> sentences;
    for (const auto& [file, what] : std::exchange(left_out().noted, {})) {
        std::string names;
        for (std::size_t i = 0; i < what.size(); ++i)
            names += (i == 0 ? "" : i + 1 == what.size() ? " and " : ", ") + what[i];
        sentences.push_back(file + ": its " + names +
                            " are left out; the mesh has the shape that is stored before them.");
    }
    return sentences;
}

}  // namespace scb::scenes
