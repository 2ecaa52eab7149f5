#include "core/collide/pairs_hash.h"

#include <array>
#include <charconv>

namespace scb {
namespace {

class Fnv1a {
  public:
    explicit Fnv1a(std::uint64_t start) : value_(start) {}

    void add(char byte) {
        constexpr std::uint64_t prime = 0x100000001b3;
        value_ = (value_ ^ static_cast<unsigned char>(byte)) * prime;
    }
    void add(std::uint32_t number) {
        std::array<char, 10> decimal;
        const char* end =
            std::to_chars(decimal.data(), decimal.data() + decimal.size(), number).ptr;
        for (const char* digit = decimal.data(); digit != end; ++digit) add(*digit);
    }
    std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_;
};

}  // namespace

std::uint64_t pairs_hash(std::span<const IndexPair> pairs, std::uint64_t start) {
    Fnv1a hash(start);
    for (const IndexPair& pair : pairs) {
        hash.add(pair.a);
        hash.add(' ');
        hash.add(pair.b);
        hash.add('\n');
    }
    return hash.value();
}

std::uint64_t joined_hash(std::span<const std::uint64_t> hashes) {
    std::uint64_t joined = hashes.empty() ? fnv_offset_basis : hashes.front();
    for (std::size_t i = 1; i < hashes.size(); ++i) {
        Fnv1a hash(joined);
        for (const char digit : hash_text(hashes[i])) hash.add(digit);
        joined = hash.value();
    }
    return joined;
}

std::string hash_text(std::uint64_t hash) {
    constexpr std::size_t size = 16;
    std::string text(size, '0');
    for (std::size_t i = size; i-- > 0; hash >>= 4) text[i] = "0123456789abcdef"[hash & 0xf];
    return text;
}

}  // namespace scb
