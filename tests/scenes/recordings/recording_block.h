#pragma once

#include <zlib.h>

#include <string>

#include "scenes/recordings/recording_file.h"

namespace scb::scenes {

/// A recording of one block that holds these bytes, with the checksum that they ask for.
inline std::string recording_with_block(const std::string& payload,
                                        const std::string& kind = "data") {
    const std::string checked = kind + payload;
    ByteWriter length, sum;
    length.fixed32(static_cast<std::uint32_t>(payload.size()));
    sum.fixed32(static_cast<std::uint32_t>(
        crc32_z(0, reinterpret_cast<const Bytef*>(checked.data()), checked.size())));
    std::string bytes = RecordingWriter().finish();
    bytes.append(length.bytes.begin(), length.bytes.end());
    bytes += checked;
    bytes.append(sum.bytes.begin(), sum.bytes.end());
    return bytes;
}

}  // namespace scb::scenes
