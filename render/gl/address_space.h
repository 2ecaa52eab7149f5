#pragma once

#include <cstdint>

namespace scb::render {

/// Throws DrawError if the address space of this process is limited (ulimit -v) and has less room
/// left. OpenGL libraries crash if memory runs out, so call this before they allocate.
void require_address_space(std::uint64_t bytes);

}  // namespace scb::render
