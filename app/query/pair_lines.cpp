#include "app/query/pair_lines.h"

#include "app/query/query_title.h"
#include "app/report/table.h"
#include "core/base/text_format.h"

namespace scb::app {

std::string pair_lines_header(const SceneQuery& query, bool with_patches) {
    return std::string("frame,") + (is_of_many(query) ? "body_a,body_b," : "") +
           (query.options.stop_level >= 0 ? "node_a,node_b" : "triangle_a,triangle_b") +
           (with_patches ? ",patch\n" : "\n");
}

std::string pair_lines(const SceneQuery& query, int frame, std::span<const IndexPair> pairs,
                       std::span<const std::uint32_t> patches) {
    std::string start = format("%d,", frame), lines;
    if (is_of_many(query))
        start +=
            csv_field(body_name(query, query.a)) + "," + csv_field(body_name(query, query.b)) + ",";
    for (std::size_t i = 0; i < pairs.size(); ++i)
        lines += start + format("%u,%u", pairs[i].a, pairs[i].b) +
                 (patches.empty() ? "\n" : format(",%u\n", patches[i]));
    return lines;
}

}  // namespace scb::app
