#pragma once

#include <filesystem>
#include <iostream>
#include <string>

namespace scb {

/// The folder of real meshes that lies beside the project on the machines that have it.
inline std::filesystem::path models_folder() {
    return std::filesystem::path(SCB_SOURCE_DIR) / ".." / "shared" / "models";
}

/// Whether the folder has the file. Where it has not, says loudly what is not tested for that.
inline bool has_model_file(const std::string& file, const std::string& untested) {
    if (std::filesystem::exists(models_folder() / file)) return true;
    std::cerr << "NOT TESTED: " << untested << ", since " << (models_folder() / file).string()
              << " does not exist here.\n";
    return false;
}

}  // namespace scb
