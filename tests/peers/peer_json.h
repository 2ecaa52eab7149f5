#pragma once

#include <span>
#include <string>

#include "tests/peers/comparison_group.h"

namespace scb {

/// Everything that was found, as a JSON document: `query` ("all_pairs" or "first_contact"), `peers`
/// (name, title, method) and `scenes`, each with its frames and, per peer, pairs, times per frame
/// and their means in milliseconds.
std::string peer_json(std::span<const PeerKind> kinds, std::span<const ComparisonGroup> groups,
                      PeerQuery query);

}  // namespace scb
