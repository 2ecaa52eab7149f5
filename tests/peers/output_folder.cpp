#include "tests/peers/output_folder.h"

#include <filesystem>

#include "core/platform/output_file.h"

namespace scb {

void make_folder(const std::string& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        throw OutputError("Cannot make the folder \"" + folder + "\": " + error.message() +
                          "; choose another with -o.");
}

}  // namespace scb
