#include "app/query/contact_intervals.h"

#include <nlohmann/json.hpp>

#include "core/base/text_format.h"

namespace scb::app {

using Json = nlohmann::ordered_json;

void ContactIntervals::add(int frame, bool in_contact) {
    if (in_contact && was_in_contact_)
        intervals_.back().last = frame;
    else if (in_contact)
        intervals_.push_back({frame, frame});
    was_in_contact_ = in_contact;
}

std::string ContactIntervals::words() const {
    const bool is_one = intervals_.size() == 1 && intervals_[0].first == intervals_[0].last;
    std::string text = is_one ? "frame " : "frames ";
    for (std::size_t i = 0; i < intervals_.size(); ++i) {
        if (i == most_named)
            return text + " and " + count_text(intervals_.size() - i) + " more intervals";
        const auto [first, last] = intervals_[i];
        text += (i == 0 ? "" : ", ") + std::to_string(first);
        if (last != first) text += " to " + std::to_string(last);
    }
    return text;
}

Json ContactIntervals::json() const {
    Json json = Json::array();
    for (const auto [first, last] : intervals_) json.push_back({first, last});
    return json;
}

std::string among_queried(const std::vector<int>& frames) {
    const bool are_all = static_cast<std::size_t>(frames.back() - frames.front()) < frames.size();
    return are_all ? ".\n" : ", of those queried.\n";
}

}  // namespace scb::app
