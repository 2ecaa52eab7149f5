#pragma once

#include <cstdint>

namespace scb::render {

/// Throws DrawError where the address space of this process is limited (ulimit -v) and has no such
/// room left: where memory runs out, OpenGL libraries crash. To be asked before they take it.
void require_address_space(std::uint64_t bytes);

}  // namespace scb::render
