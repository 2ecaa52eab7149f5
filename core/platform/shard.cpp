#include "core/platform/shard.h"

#include <cassert>
#include <charconv>
#include <optional>
#include <string>

#include "scb/error.h"

namespace scb {
namespace {

std::optional<std::size_t> shard_number(std::string_view digits) {
    std::size_t number = 0;
    const char* end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, number);
    if (error != std::errc() || stop != end) return std::nullopt;
    return number;
}

}  // namespace

Shard parse_shard(std::string_view text) {
    const std::size_t slash = text.find('/');
    if (slash != std::string_view::npos) {
        const auto k = shard_number(text.substr(0, slash)),
                   n = shard_number(text.substr(slash + 1));
        if (k && n && *k >= 1 && *k <= *n) return {*k, *n};
    }
    throw InputError("\"" + std::string(text) +
                     "\" is not a shard; give K/N, the K-th of N parts, such as 2/3.");
}

bool in_shard(const Shard& shard, std::size_t index) {
    assert(shard.k >= 1 && shard.k <= shard.n && "shards are numbered from 1 to n");
    return index % shard.n == shard.k - 1;
}

}  // namespace scb
