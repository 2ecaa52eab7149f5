#pragma once

#include <cstdint>
#include <string>

namespace scb::scenes {

/// The most seconds that a confined process may run.
inline constexpr unsigned reader_patience = 300;

/// Confines this process permanently, before it reads untrusted files. It ends with its starting
/// process, leaves no core file, opens nothing to write, changes no file's mode, owner or time, and
/// reaches no network, no other program and no other process. It has 1.5 GiB of address space, 8
/// seconds of processor time and five minutes, plus the additions of allow_for; it never has more
/// than its starting process.
///
/// Returns why this is not possible, or nothing. `answers` is the descriptor of the pipe to the
/// starting process.
std::string confine_this_process(int answers);

/// Allows 64 bytes of address space for each byte of an opened file, up to 12 GiB in all, and 2
/// seconds of processor time for each 10^6 bytes, up to five minutes. Not for threads.
void allow_for(std::uint64_t file_bytes);

/// The address space that this process may have now.
struct AddressSpace {
    std::uint64_t bytes = 0;
    bool inherited = false;  ///< a limit from outside makes it less than allow_for would
};
AddressSpace address_space();

}  // namespace scb::scenes
