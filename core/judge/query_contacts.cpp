#include "core/judge/query_contacts.h"

#include <algorithm>
#include <cmath>

#include "core/analysis/level_overlaps.h"

namespace scb {
namespace {

/// An object and the box about its volume in A's frame, enlarged by the tolerance.
struct Extent {
    std::uint32_t object = 0;
    const NodeVolume* volume = nullptr;
    Vec3 lower, upper;
};

std::vector<Extent> extents(const EngineSide& side, const Pose& to_a, double tolerance) {
    std::vector<Extent> result;
    for (std::uint32_t object = 0; object < side.shape->holder.size(); ++object) {
        const NodeVolume* volume = volume_of_object(side, object);
        if (!volume || !has_volume(*volume)) continue;
        const Box box = box_about(placed(convex_shape(*volume), to_a));
        result.push_back(
            {object, volume, box.lower.array() - tolerance, box.upper.array() + tolerance});
    }
    return result;
}

/// The axis along which the lower ends have the greatest variance, since few extents overlap along
/// it.
int widest_axis(const std::vector<Extent>& of_a, const std::vector<Extent>& of_b) {
    Vec3 sum = Vec3::Zero(), squares = Vec3::Zero();
    const auto count = static_cast<double>(of_a.size() + of_b.size());
    for (const std::vector<Extent>* extents : {&of_a, &of_b})
        for (const Extent& extent : *extents) {
            sum += extent.lower / count;
            squares += extent.lower.cwiseAbs2() / count;
        }
    int axis = 0;
    (squares - sum.cwiseAbs2()).maxCoeff(&axis);
    return axis;
}

bool apart(const Extent& a, const Extent& b) {
    return (a.upper.array() < b.lower.array()).any() || (b.upper.array() < a.lower.array()).any();
}

}  // namespace

const NodeVolume* volume_of_object(const EngineSide& side, std::uint32_t object) {
    if (const NodeVolume* extent = side.tree->object_volume(object)) return extent;
    const std::uint32_t node = side.shape->holder_of(object);
    return node == no_index ? nullptr : &(*side.tree)[node].volume;
}

bool has_object_volumes(const EngineQuery& query) {
    return query.sides[0].objects_by_volume && query.sides[1].objects_by_volume;
}

std::vector<IndexPair> object_contacts(const EngineQuery& query) {
    const EngineSide &side_a = query.sides[0], &side_b = query.sides[1];
    std::vector<Extent> of_a = extents(side_a, Pose{}, query.tolerance),
                        of_b = extents(side_b, query.b_to_a, query.tolerance);
    const int axis = widest_axis(of_a, of_b);
    for (std::vector<Extent>* sorted : {&of_a, &of_b})
        std::sort(sorted->begin(), sorted->end(), [axis](const Extent& x, const Extent& y) {
            return std::pair(x.lower[axis], x.object) < std::pair(y.lower[axis], y.object);
        });
    std::vector<IndexPair> contacts;
    const auto take = [&](const Extent& a, const Extent& b) {
        if (apart(a, b) || (query.self && a.object >= b.object)) return;
        const ContactCertificate found =
            exact_verdict(*a.volume, *b.volume, query.b_to_a, query.tolerance);
        if (found.contact != Contact::disjoint) contacts.push_back({a.object, b.object});
    };
    // Each extent begins at its lower end, and meets the open extents of the other side.
    std::vector<const Extent*> open_a, open_b;
    std::size_t next_a = 0, next_b = 0;
    const auto end_before = [axis](std::vector<const Extent*>& open, double at) {
        std::erase_if(open, [=](const Extent* extent) { return extent->upper[axis] < at; });
    };
    while (next_a < of_a.size() || next_b < of_b.size()) {
        const bool is_a =
            next_b == of_b.size() ||
            (next_a < of_a.size() && of_a[next_a].lower[axis] <= of_b[next_b].lower[axis]);
        const Extent& begun = is_a ? of_a[next_a++] : of_b[next_b++];
        std::vector<const Extent*>& others = is_a ? open_b : open_a;
        end_before(others, begun.lower[axis]);
        for (const Extent* other : others) is_a ? take(begun, *other) : take(*other, begun);
        (is_a ? open_a : open_b).push_back(&begun);
    }
    std::sort(contacts.begin(), contacts.end());
    return contacts;
}

std::vector<std::size_t> level_overlaps(const EngineQuery& query, std::size_t most) {
    if (query.self || !query.placed) return {};
    const EngineSide &a = query.sides[0], &b = query.sides[1];
    return level_overlaps(
        *a.shape, *b.shape,
        [&](std::uint32_t x, std::uint32_t y) {
            return exact_verdict((*a.tree)[x].volume, (*b.tree)[y].volume, query.b_to_a,
                                 tolerance_of(query, {x, y}))
                       .contact != Contact::disjoint;
        },
        most);
}

}  // namespace scb
