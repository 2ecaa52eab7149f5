#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace scb {

/// "1,2,3" cut at the separators; empty parts stay.
std::vector<std::string> split_list(const std::string& text, char separator = ',');

/// An integer that is the whole text; throws an InputError that starts with `what` and ends with
/// `hint`.
int whole_number(const std::string& text, const std::string& what, const std::string& hint = ".");
/// The same up to 2^63.
std::int64_t large_number(const std::string& text, const std::string& what,
                          const std::string& hint = ".");

/// The allowed numbers of a list.
struct NumberRange {
    std::string option;  ///< the option before the list, such as "--frames"
    std::string noun;    ///< the counted things: "frame"
    std::string whole;   ///< their owner: "the scene 'cone' has"
    int last = 0;        ///< they run from 0 to here
    std::string example;
};

/// One part of a list: "7", "0:499" or "0-499", or "0:499:10". Throws InputError, one sentence that
/// starts with the option, if it is not such a part or leaves the range.
std::vector<int> parse_numbers(const std::string& part, const NumberRange& range);

/// The list that parse_frames reads as these numbers, which ascend: "7", "0:490:10", "1,5,7".
std::string list_text(const std::vector<int>& numbers);

/// In place of a list: the default frame of the scene.
inline constexpr const char* auto_frames = "auto";

/// The frames that a list names, "all" or "5,7,0:499:10": ascending, each once. Throws InputError.
std::vector<int> parse_frames(const std::string& text, int frame_count,
                              const std::string& scene_name);

/// The same for a file that has these frames, ascending. `path` names it, `whose` describes its
/// numbers: "a trace may have".
std::vector<int> frames_among(const std::vector<int>& all, const std::string& list,
                              const std::string& path, const std::string& whose);

}  // namespace scb
