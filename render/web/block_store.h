#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <tuple>

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

    /// Adds a block, or finds an equal one; returns its number. The bytes stand in planes: all
    /// first bytes of the elements, then all second bytes. So numbers of like size compress better.
    std::size_t add(std::span<const std::uint8_t> values) { return add(Type::u8, values, 1); }
    std::size_t add(std::span<const std::uint32_t> values);
    std::size_t add(std::span<const float> values);
    std::size_t add(std::span<const double> values);
    /// UTF-8, as u8.
    std::size_t add(std::string_view text);
    /// A block of another store.
    std::size_t add(const Block& block);

    const std::deque<Block>& blocks() const { return blocks_; }

  private:
    std::size_t add(Type type, std::span<const std::uint8_t> bytes, std::size_t element);

    std::deque<Block> blocks_;  // whose texts stay where they are
    std::map<std::tuple<Type, std::size_t, std::string_view>, std::size_t> places_;
};

}  // namespace scb::render
