#include "render/web/block_store.h"

#include <zlib.h>

#include <bit>
#include <new>
#include <vector>

#include "core/platform/base64.h"

namespace scb::render {
namespace {

static_assert(std::endian::native == std::endian::little, "browsers' arrays are");

template <class T>
std::span<const std::uint8_t> bytes_of(std::span<const T> values) {
    return {reinterpret_cast<const std::uint8_t*>(values.data()), values.size_bytes()};
}

}  // namespace

std::size_t BlockStore::add(std::span<const std::uint32_t> values) {
    return add(Type::u32, bytes_of(values), sizeof(values[0]));
}
std::size_t BlockStore::add(std::span<const float> values) {
    return add(Type::f32, bytes_of(values), sizeof(values[0]));
}
std::size_t BlockStore::add(std::span<const double> values) {
    return add(Type::f64, bytes_of(values), sizeof(values[0]));
}

std::size_t BlockStore::add(std::string_view text) {
    return add(Type::u8, bytes_of(std::span<const char>(text)), 1);
}

std::size_t BlockStore::add(Type type, std::span<const std::uint8_t> bytes, std::size_t element) {
    const std::size_t count = bytes.size() / element;
    std::vector<std::uint8_t> planes(bytes.size());
    for (std::size_t i = 0; i < bytes.size(); ++i)
        planes[i % element * count + i / element] = bytes[i];
    uLongf size = compressBound(static_cast<uLong>(planes.size()));
    std::vector<std::uint8_t> packed(size);
    constexpr int level = 6;
    if (compress2(packed.data(), &size, planes.data(), static_cast<uLong>(planes.size()), level) !=
        Z_OK)
        throw std::bad_alloc();
    packed.resize(size);
    return add(Block{type, count, base64(packed)});
}

std::size_t BlockStore::add(const Block& block) {
    blocks_.push_back(block);
    const auto [place, is_new] =
        places_.try_emplace({block.type, block.count, blocks_.back().text}, blocks_.size() - 1);
    if (!is_new) blocks_.pop_back();
    return place->second;
}

}  // namespace scb::render
