#pragma once

#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scb::scenes {

inline std::span<const std::uint8_t> as_bytes(std::string_view text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// Numbers as bytes, the same on every machine: variable length integers of 7 bits a byte, lowest
/// first, with the top bit set on all but the last; doubles and fixed integers lowest byte first.
struct ByteWriter {
    std::vector<std::uint8_t> bytes;

    void byte(std::uint8_t value) { bytes.push_back(value); }
    void varint(std::uint64_t value) {
        for (; value >= 0x80; value >>= 7) byte(static_cast<std::uint8_t>(value | 0x80));
        byte(static_cast<std::uint8_t>(value));
    }
    /// Short if the magnitude is small.
    void signed_varint(std::int64_t value) {
        varint(static_cast<std::uint64_t>(value) << 1 ^ static_cast<std::uint64_t>(value >> 63));
    }
    void fixed32(std::uint32_t value) {
        for (int shift = 0; shift < 32; shift += 8) byte(static_cast<std::uint8_t>(value >> shift));
    }
    void fixed64(std::uint64_t value) {
        for (int shift = 0; shift < 64; shift += 8) byte(static_cast<std::uint8_t>(value >> shift));
    }
    void real(double value) { fixed64(std::bit_cast<std::uint64_t>(value)); }
    void text(std::string_view value) {
        varint(value.size());
        bytes.insert(bytes.end(), value.begin(), value.end());
    }
    void append(std::span<const std::uint8_t> more) {
        bytes.insert(bytes.end(), more.begin(), more.end());
    }
};

/// Reads what ByteWriter wrote. If bytes run out, or a varint is invalid, `ok` becomes false and
/// all further values are 0 or empty: one check at the end is enough. `take` refers to the bytes.
struct ByteReader {
    std::span<const std::uint8_t> bytes;
    bool ok = true;

    std::uint8_t byte() {
        if (bytes.empty()) return fail();
        const std::uint8_t value = bytes[0];
        bytes = bytes.subspan(1);
        return value;
    }
    std::uint64_t varint() {
        std::uint64_t value = 0;
        for (int shift = 0; shift < 70; shift += 7) {
            const std::uint64_t next = byte();
            const std::uint64_t bits = next & 0x7f;
            if (shift == 63 && bits > 1) return fail();
            value |= bits << shift;
            if (next < 0x80) return ok ? value : 0;
        }
        return fail();
    }
    std::int64_t signed_varint() {
        const std::uint64_t value = varint();
        return static_cast<std::int64_t>(value >> 1) ^ -static_cast<std::int64_t>(value & 1);
    }
    std::uint32_t fixed32() { return static_cast<std::uint32_t>(fixed(32)); }
    std::uint64_t fixed64() { return fixed(64); }
    double real() { return std::bit_cast<double>(fixed64()); }
    std::span<const std::uint8_t> take(std::uint64_t count) {
        if (count > bytes.size()) {
            fail();
            return {};
        }
        const auto taken = bytes.first(static_cast<std::size_t>(count));
        bytes = bytes.subspan(taken.size());
        return taken;
    }
    std::string text() {
        const auto taken = take(varint());
        return {taken.begin(), taken.end()};
    }

  private:
    std::uint8_t fail() {
        ok = false;
        bytes = {};
        return 0;
    }
    std::uint64_t fixed(int bits) {
        if (bytes.size() < static_cast<std::size_t>(bits / 8)) return fail();
        std::uint64_t value = 0;
        for (int shift = 0; shift < bits; shift += 8)
            value |= static_cast<std::uint64_t>(byte()) << shift;
        return value;
    }
};

}  // namespace scb::scenes
