#pragma once

#include <optional>
#include <span>
#include <string>

#include "tests/peers/comparison_group.h"

namespace scb {

/// What was found as Markdown: pair sets, warm times, cold times, building, and how the peers were
/// called. Every group of scenes has its own table of each.
std::string peer_tables(std::span<const PeerKind> kinds, std::span<const ComparisonGroup> groups,
                        PeerQuery query);

/// The position of the peer of that name; nothing where it does not take part.
std::optional<std::size_t> find_peer(std::span<const PeerKind> kinds, const std::string& name);

}  // namespace scb
