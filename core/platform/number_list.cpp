#include "core/platform/number_list.h"

#include <algorithm>
#include <charconv>

#include "scb/error.h"

namespace scb {
namespace {

template <class Number>
Number parsed_number(const std::string& text, const std::string& what, const std::string& hint) {
    Number value = 0;
    const char* end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data(), end, value);
    if (text.empty() || parsed.ec != std::errc() || parsed.ptr != end)
        throw InputError(what + ": '" + text + "' is not a whole number" + hint);
    return value;
}

/// Of FIRST:LAST[:STEP], or of FIRST-LAST.
std::vector<std::string> bounds_of(const std::string& part) {
    const std::size_t dash = part.find('-', 1);
    if (dash == part.npos || part.find(':') != part.npos) return split_list(part, ':');
    return {part.substr(0, dash), part.substr(dash + 1)};
}

}  // namespace

std::vector<std::string> split_list(const std::string& text, char separator) {
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (c == separator)
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

int whole_number(const std::string& text, const std::string& what, const std::string& hint) {
    return parsed_number<int>(text, what, hint);
}

std::int64_t large_number(const std::string& text, const std::string& what,
                          const std::string& hint) {
    return parsed_number<std::int64_t>(text, what, hint);
}

std::vector<int> parse_numbers(const std::string& part, const NumberRange& range) {
    const std::vector<std::string> bounds = bounds_of(part);
    if (bounds.size() > 3)
        throw InputError(range.option + ": '" + part +
                         "' is not a range; give FIRST:LAST or FIRST:LAST:STEP.");
    const std::string hint = "; give " + range.example + ".";
    const int first = whole_number(bounds[0], range.option, hint);
    const int last = bounds.size() > 1 ? whole_number(bounds[1], range.option, hint) : first;
    const int step = bounds.size() > 2 ? whole_number(bounds[2], range.option, hint) : 1;
    if (step < 1 || last < first)
        throw InputError(
            range.option + ": '" + part +
            "' names nothing; give FIRST:LAST[:STEP] with FIRST <= LAST and STEP >= 1.");
    for (const int number : {first, last})
        if (number < 0 || number > range.last)
            throw InputError(range.option + ": there is no " + range.noun + " " +
                             std::to_string(number) + "; " + range.whole + " the " + range.noun +
                             "s 0 to " + std::to_string(range.last) + ".");
    constexpr int most = 10'000'000;
    if ((last - first) / step >= most)
        throw InputError(range.option + ": '" + part + "' names more than 10,000,000 " +
                         range.noun + "s; give fewer.");
    std::vector<int> numbers;
    for (long number = first; number <= last; number += step)
        numbers.push_back(static_cast<int>(number));
    return numbers;
}

std::string list_text(const std::vector<int>& numbers) {
    // A shorter list is as easy to read in full.
    constexpr std::size_t least_in_range = 4;
    const int step = numbers.size() < least_in_range ? 0 : numbers[1] - numbers[0];
    const auto is_gap = [step](int x, int y) { return y - x != step; };
    if (step > 0 && std::adjacent_find(numbers.begin(), numbers.end(), is_gap) == numbers.end())
        return std::to_string(numbers.front()) + ":" + std::to_string(numbers.back()) +
               (step == 1 ? "" : ":" + std::to_string(step));
    std::string text;
    for (const int number : numbers) text += (text.empty() ? "" : ",") + std::to_string(number);
    return text;
}

std::vector<int> parse_frames(const std::string& text, int frame_count,
                              const std::string& scene_name) {
    const NumberRange range{"--frames " + text, "frame", "the scene '" + scene_name + "' has",
                            frame_count - 1, "frames such as 0,250 or 0:499:10 or all"};
    std::vector<int> frames;
    for (const std::string& part : split_list(text)) {
        const std::vector<int> numbers =
            parse_numbers(part == "all" ? "0:" + std::to_string(range.last) : part, range);
        frames.insert(frames.end(), numbers.begin(), numbers.end());
    }
    std::sort(frames.begin(), frames.end());
    frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
    return frames;
}

std::vector<int> frames_among(const std::vector<int>& all, const std::string& list,
                              const std::string& path, const std::string& whose) {
    std::vector<int> wanted;
    for (const std::string& part : split_list(list)) {
        const std::vector<int> numbers =
            part == "all" ? all
                          : parse_numbers(part, {"--frames " + list, "frame", whose,
                                                 std::max(999'999, all.back()),
                                                 "frames such as 0,250 or all"});
        wanted.insert(wanted.end(), numbers.begin(), numbers.end());
    }
    std::sort(wanted.begin(), wanted.end());
    wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
    for (const int frame : wanted)
        if (!std::binary_search(all.begin(), all.end(), frame))
            throw InputError("--frames " + list + ": " + path + " has no frame " +
                             std::to_string(frame) + "; it has " + std::to_string(all.size()) +
                             " from " + std::to_string(all.front()) + " to " +
                             std::to_string(all.back()) + ".");
    return wanted;
}

}  // namespace scb
