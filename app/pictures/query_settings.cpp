#include "app/pictures/query_settings.h"

#include <cmath>

#include "app/report/build_text.h"
#include "core/base/text_format.h"

namespace scb::app {

std::vector<std::string> settings_in_common(const TraceHeader& header, const TraceHeader& other,
                                            const std::function<bool(const char*)>& common) {
    std::vector<std::string> parts;
    const TraceHeader& of_scb = header.volume == VolumeKind::scb ? header : other;
    if (of_scb.volume == VolumeKind::scb && !is_of_distance(header.kind)) {
        const OverlapOptions& overlap = of_scb.options.overlap;
        // For two kinds of volumes the captions name the test, since only one kind has it.
        if (common("test") && other.volume == header.volume)
            parts.push_back("test " + std::string(overlap_test_name(overlap.test)));
        if (common("threshold") && has_threshold(overlap.test) &&
            overlap.threshold != OverlapOptions{}.threshold)
            parts.push_back(format("threshold %g", overlap.threshold));
    }
    if (header.kind == QueryKind::distance) {
        const DistanceOptions& limits = header.distance;
        if (limits.order != DistanceOptions{}.order)
            parts.push_back("order " + std::string(distance_order_name(limits.order)));
        if (limits.relative_error > 0)
            parts.push_back(format("relative error up to %g", limits.relative_error));
        if (std::isfinite(limits.limit)) parts.push_back(format("limit %g", limits.limit));
    }
    if (common("descent") && header.options.descent != CollideOptions{}.descent)
        parts.push_back("descent by " + std::string(descent_rule_name(header.options.descent)));
    BuildOptions build;
    if (common("growth")) build.fit.growth = header.growth;
    if (common("margin")) build.fit.margin = header.margin;
    if (common("split")) build.split = header.split;
    for (const std::string& part : build_parts(build)) parts.push_back(part);
    return parts;
}

}  // namespace scb::app
