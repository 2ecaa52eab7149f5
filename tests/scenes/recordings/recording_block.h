#pragma once

#include <string>
#include <vector>

#include "scenes/recordings/recording_file.h"
#include "scenes/recordings/trace_block.h"

namespace scb::scenes {

/// A recording of one block that holds these bytes, with the checksum that they ask for.
inline std::string recording_with_block(const std::string& payload,
                                        const std::string& kind = "data") {
    ByteWriter out;
    begin_recording(out);
    add_block(out, kind, as_bytes(payload));
    return {out.bytes.begin(), out.bytes.end()};
}

/// The bytes of a recording with checksums that fit its blocks, up to the first block that is cut
/// off.
inline std::vector<std::uint8_t> with_fitting_checksums(std::vector<std::uint8_t> bytes) {
    std::size_t at = recording_magic.size() + 4;
    while (at < bytes.size()) {
        ByteReader in{std::span<const std::uint8_t>(bytes).subspan(at)};
        const std::uint64_t length = in.fixed32();
        const std::uint32_t sum = checksum(in.take(4 + length));
        in.fixed32();
        if (!in.ok) break;
        at += 12 + static_cast<std::size_t>(length);
        for (std::size_t i = 0; i < 4; ++i)
            bytes[at - 4 + i] = static_cast<std::uint8_t>(sum >> (8 * i));
    }
    return bytes;
}

}  // namespace scb::scenes
