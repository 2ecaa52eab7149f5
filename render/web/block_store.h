#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace scb::render {

/// The arrays of a page, each compressed by itself, so that a browser unpacks what it shows.
class BlockStore {
  public:
    /// As JavaScript's typed arrays are called: Uint8Array, Uint32Array, Float32Array,
    /// Float64Array.
    enum class Type { u8, u32, f32, f64 };

    struct Block {
        Type type;
        std::size_t count;  ///< elements
        std::string text;   ///< base 64 of a zlib stream
    };

    /// Returns its number. The bytes are told in planes, all first bytes of the elements, then all
    /// second ones: numbers of like size compress to less so.
    std::size_t add(std::span<const std::uint8_t> values) { return add(Type::u8, values, 1); }
    std::size_t add(std::span<const std::uint32_t> values);
    std::size_t add(std::span<const float> values);
    std::size_t add(std::span<const double> values);

    const std::vector<Block>& blocks() const { return blocks_; }

  private:
    std::size_t add(Type type, std::span<const std::uint8_t> bytes, std::size_t element);

    std::vector<Block> blocks_;
};

}  // namespace scb::render
