#include "golden/report/result_lines.h"

#include "golden/compare/number_words.h"
#include "golden/report/plain_text.h"

namespace scb::golden {
namespace {

// Logs are read with tools that often support only ASCII.
constexpr const char* minus = "-";

std::string value_of(const std::optional<std::int64_t>& count, const std::string& text) {
    return count ? words::grouped_signed(*count, minus) : text.empty() ? "none" : text;
}

std::string line_of(const CountChange& change) {
    if (is_hash(change) && change.before && change.after) return change.place + ": changed";
    std::string line = change.place + ": " + value_of(change.before, change.before_text) + " -> " +
                       value_of(change.after, change.after_text);
    if (change.before && change.after)
        line += " (" + words::change_of(*change.before, *change.after, minus) + ")";
    return line;
}

}  // namespace

std::vector<std::string> count_lines(const CaseResult& result, std::size_t most) {
    std::vector<std::string> lines;
    std::size_t more = 0;
    for (const CountChange& change : result.counts) {
        if (is_of_trace(change)) continue;
        if (lines.size() < most)
            lines.push_back(plain_text(line_of(change)));
        else
            ++more;
    }
    if (more > 0) lines.push_back("and " + words::counted(more, "more count", "more counts"));
    return lines;
}

std::vector<std::string> result_lines(const CaseResult& result) {
    std::vector<std::string> lines = count_lines(result);
    for (const std::string& line : result.lines) lines.push_back(plain_text(line));
    return lines;
}

}  // namespace scb::golden
