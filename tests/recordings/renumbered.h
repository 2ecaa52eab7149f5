#pragma once

#include <cstdint>
#include <string>

namespace scb {

/// The number that a node of a tree has there in place of its own: neither tree counts upwards from
/// 0, and both leave numbers out.
std::uint32_t renumbered(std::uint32_t tree, std::uint32_t node);

/// The bytes of a recording in which every node has such a number, and each seventh a name, "node
/// of N", by its own. All else is as in the recording of these bytes.
std::string renumbered(const std::string& bytes);

}  // namespace scb
