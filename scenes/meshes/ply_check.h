#pragma once

#include <string>
#include <string_view>

namespace scb::scenes {

/// Checks a PLY file from its first byte to its last, without keeping anything: the header, that
/// every declared element is there, and that faces name vertices that exist. assimp's reader hangs
/// on a header without an end, allocates whatever a header declares, and makes up the faces that a
/// truncated file lacks, so it only gets files that pass. Takes a small part of the time of
/// reading. Like assimp, it takes header lines of unknown words for remarks, unless they read as a
/// misspelled element or property.
///
/// Throws InputError that names the file and the header line, vertex or face at fault.
void check_ply(std::string_view bytes, const std::string& name);

}  // namespace scb::scenes
