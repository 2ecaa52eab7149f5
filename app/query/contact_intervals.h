#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace scb::app {

/// The frames in which two bodies are in contact, as intervals of queried frames.
class ContactIntervals {
  public:
    /// Frames must be added in ascending order.
    void add(int frame, bool in_contact);

    /// Whether the frame that was added last is in contact.
    bool is_last_in_contact() const { return was_in_contact_; }
    bool empty() const { return intervals_.empty(); }
    /// "frames 12 to 40, 55"; "frame 55".
    std::string words() const;
    /// [[12, 40], [55, 55]]
    nlohmann::ordered_json json() const;

  private:
    struct Interval {
        int first = 0, last = 0;
    };

    static constexpr std::size_t most_named = 20;

    std::vector<Interval> intervals_;
    bool was_in_contact_ = false;
};

/// The end of a sentence that lists such intervals: whether frames between were left out.
std::string among_queried(const std::vector<int>& frames);

}  // namespace scb::app
