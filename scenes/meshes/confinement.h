#pragma once

#include <cstdint>
#include <string>

namespace scb::scenes {

/// Seconds that a confined process has at most.
inline constexpr unsigned reader_patience = 300;

/// Confines this process, which is about to read files of strangers, for good. It ends with who
/// started it, leaves no core file, opens nothing to write, changes no file's mode, owner or time,
/// and reaches no network, no other program and no other process. It has 1.5 GiB of address space,
/// 8 seconds of processor time and five minutes, besides what allow_for adds; it never has more
/// than whoever started it.
///
/// Returns why that cannot be arranged, or nothing. `answers` is the descriptor of the pipe that
/// leads to who started it.
std::string confine_this_process(int answers);

/// Allows 64 bytes of address space for each byte of a file that is opened, up to 12 GiB in all,
/// and 2 seconds of processor time for each 10^6, up to five minutes. Not for threads.
void allow_for(std::uint64_t file_bytes);

/// The address space that this process may have now.
struct AddressSpace {
    std::uint64_t bytes = 0;
    bool inherited = false;  ///< it is less than allow_for would give, by a limit from outside
};
AddressSpace address_space();

}  // namespace scb::scenes
