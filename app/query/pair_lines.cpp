#include "app/query/pair_lines.h"

#include "app/query/query_title.h"
#include "app/report/table.h"
#include "core/base/text_format.h"

namespace scb::app {

std::string pair_lines_header(const SceneQuery& query) {
    return std::string("frame,") + (is_of_many(query) ? "body_a,body_b," : "") +
           (query.options.stop_level >= 0 ? "node_a,node_b\n" : "triangle_a,triangle_b\n");
}

std::string pair_lines(const SceneQuery& query, int frame, std::span<const IndexPair> pairs) {
    std::string start = format("%d,", frame), lines;
    if (is_of_many(query))
        start +=
            csv_field(body_name(query, query.a)) + "," + csv_field(body_name(query, query.b)) + ",";
    for (const IndexPair& pair : pairs) lines += start + format("%u,%u\n", pair.a, pair.b);
    return lines;
}

}  // namespace scb::app
