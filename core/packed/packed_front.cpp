#include "scb/packed_front.h"

#include "core/packed/packed_query.h"

namespace scb {

PackedFront::PackedFront() : parts_(std::make_unique<Parts>()) {}
PackedFront::~PackedFront() = default;
PackedFront::PackedFront(PackedFront&&) noexcept = default;
PackedFront& PackedFront::operator=(PackedFront&&) noexcept = default;

void PackedFront::clear() {
    parts_->schedule = {};
    parts_->pairs.clear();
}

std::uint64_t PackedFront::made() const { return parts_->schedule.made; }
std::uint64_t PackedFront::used() const { return parts_->schedule.used; }

}  // namespace scb
