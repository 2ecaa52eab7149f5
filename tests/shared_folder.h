#pragma once

#include <filesystem>
#include <string>

namespace scb {

/// The folder of shared models and cases beside the project; empty where it is not there.
inline std::string shared_folder() {
    const std::string folder = std::string(SCB_SOURCE_DIR) + "/../shared";
    return std::filesystem::is_directory(folder) ? folder : std::string();
}

}  // namespace scb
