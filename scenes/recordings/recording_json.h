#pragma once

#include <iosfwd>
#include <string>
#include <string_view>

#include "core/base/enum_names.h"
#include "scenes/recordings/record.h"

namespace scb::scenes {

/// The names of the kinds of volumes in JSON Lines.
inline constexpr EnumNames<RecordedKind, recorded_kind_count> recorded_kind_names{
    "none", "aabb", "obb", "ball", "capsule", "rss", "kdop", "scb", "scb2", "hull"};

/// The names of the aims of queries.
inline constexpr EnumNames<RecordedAim, recorded_aim_count> recorded_aim_names{
    "overlap", "distance", "within"};

/// Writes records as JSON Lines: one line per record, and one line for up to a hundred tests that
/// follow each other. README.md of this folder lists the fields. Numbers read back unchanged.
/// Non-finite numbers are "nan", "inf", "-inf", and texts that are not UTF-8 are {"hex": "..."}.
class RecordingJsonWriter {
  public:
    void add(const Record& record);
    /// The number of bytes that take() has.
    std::size_t size() const { return text_.size(); }
    /// The lines that are complete since the last call.
    std::string take();
    /// The lines that take() has not returned. Nothing may be added after it.
    std::string finish();

  private:
    void end_tests();

    std::string text_, tests_;
    std::size_t test_count_ = 0;
};

/// The recording of a file's bytes as JSON Lines. Throws InputError as RecordingReader does.
std::string recording_as_json(std::string_view bytes, std::string_view name);

/// The inverse of recording_as_json. Missing fields are 0 or empty. Throws InputError, one sentence
/// that names the line, if a line is not JSON, or no record.
std::string recording_of_json(std::string_view text, const std::string& name);
std::string recording_of_json(std::istream& text, const std::string& name);

}  // namespace scb::scenes
