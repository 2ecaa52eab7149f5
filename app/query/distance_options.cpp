#include "app/query/distance_options.h"

#include <array>
#include <cmath>
#include <utility>

#include "app/cli/choice.h"
#include "app/cli/validators.h"
#include "core/base/text_format.h"
#include "scb/error.h"

namespace scb::app {
namespace {

void check_length(const std::string& option, double value) {
    if (!std::isfinite(value) || value < 0)
        throw InputError(option + format(" %g: give a finite number, 0 or more.", value));
}

/// A given option that is of the smallest distance only; empty: none.
std::string smallest_only(const DistanceQuery& query) {
    if (query.limits.relative_error != 0) return "--relative-error";
    if (!(query.limits.limit == HUGE_VAL)) return "--limit";
    if (query.limits.order != DistanceOptions{}.order) return "--order";
    return "";
}

}  // namespace

void set_distance_defaults(HierarchyOptions& hierarchy, QueryOptions& query) {
    hierarchy.volumes = volume_kind_name(VolumeKind::scb2);
    hierarchy.split = SplitMethod::cost;
    query.distance.emplace();
}

void add_distance_options(const Command& command, DistanceQuery& query) {
    constexpr std::array orders = {DistanceOrder::nearest, DistanceOrder::depth_first,
                                   DistanceOrder::hybrid};
    add_choice(command, "--order", query.limits.order,
               choices_of(std::span<const DistanceOrder>(orders), distance_order_name),
               "The pair of nodes to divide next: the one with the least bound (nearest), the "
               "nearer child (depth-first), or the least bound while few pairs wait (hybrid)")
        .type_name("ORDER")
        .shareable();
    command
        .add_option("--within", query.within,
                    "In place of the distance: the pairs of triangles that are at most this far "
                    "apart, in units of the mesh")
        .check(real_number)
        .type_name("T")
        .shareable();
    command
        .add_option("--relative-error", query.limits.relative_error,
                    "Allow a distance that is too large by at most this share: 0.01 is 1 %")
        .check(real_number)
        .type_name("E")
        .show_default()
        .shareable();
    command
        .add_option("--limit", query.limits.limit,
                    "Look for nothing beyond this distance. Default: no limit")
        .check(real_number)
        .type_name("T")
        .shareable();
}

void add_kind_options(const Command& command, KindOptions& options) {
    constexpr std::array kinds = {QueryKind::collide, QueryKind::distance};
    add_choice(
        command, "--kind", options.kind,
        choices_of(std::span<const QueryKind>(kinds), query_kind_name),
        "What queries look for: triangles that intersect (collide), or the smallest distance "
        "(distance)")
        .type_name("KIND")
        .shareable();
    add_distance_options(command, options.distance);
}

void KindOptions::apply(QueryOptions& query) const {
    query.distance.reset();
    if (kind == QueryKind::collide && !distance.within) {
        if (const std::string given = smallest_only(distance); !given.empty())
            throw InputError(given + " is of distances; add --kind distance, or leave it out.");
        return;
    }
    check_distance(distance);
    query.distance = distance;
}

void take_kind(const Command& command, std::initializer_list<const char*> of_overlap,
               const SceneOptions& scene, HierarchyOptions& hierarchy, QueryOptions& query,
               const KindOptions& options) {
    options.apply(query);
    if (!query.distance) return;
    const std::string asks = options.distance.within ? "--within" : "--kind distance";
    if (options.distance.within && options.kind == QueryKind::collide &&
        command.count("--kind") > 0)
        throw InputError(
            "--within asks for triangles within a distance, and --kind collide for "
            "triangles that intersect; leave one of them out.");
    if (scene.is_recording() || scene.is_trace())
        throw InputError(asks +
                         ": the queries of a recording or a trace have their kind; leave it out.");
    for (const char* option : of_overlap)
        if (command.count(option) > 0)
            throw InputError(std::string(option) +
                             ": it is for queries of overlap; leave it out, or " + asks + ".");
    const HierarchyOptions chosen = hierarchy, usual;
    set_distance_defaults(hierarchy, query);
    // A configuration file may have chosen them, too.
    if (command.count("--volume") > 0 || chosen.volumes != usual.volumes)
        hierarchy.volumes = chosen.volumes;
    if (command.count("--split") > 0 || chosen.split != usual.split) hierarchy.split = chosen.split;
    query.distance = options.distance;
}

void check_distance(const DistanceQuery& query) {
    const auto& [limits, within] = query;
    if (within) check_length("--within", *within);
    check_length("--relative-error", limits.relative_error);
    if (std::isnan(limits.limit) || limits.limit < 0)
        throw InputError(format("--limit %g: give 0 or more.", limits.limit));
    if (const std::string given = smallest_only(query); within && !given.empty())
        throw InputError(given +
                         " is of the smallest distance, and --within asks for all triangles within "
                         "a distance; leave one of them out.");
}

}  // namespace scb::app
