#pragma once

#include <string>

namespace scb {

/// Makes the folder of -o and the folders above it. Throws OutputError.
void make_folder(const std::string& folder);

}  // namespace scb
