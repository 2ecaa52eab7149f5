#pragma once

#include <string>
#include <string_view>

#include "scenes/recordings/record.h"

namespace scb::scenes {

/// Records as JSON Lines: a line per record, and tests that follow each other in lines of up to a
/// hundred. README.md of this folder lists the fields. Numbers are written so that they read back
/// to the same; what is no number as "nan", "inf", "-inf", and texts that are no UTF-8 as
/// {"hex": "..."}.
class RecordingJsonWriter {
  public:
    void add(const Record& record);
    /// The whole text. Nothing may be added after it.
    std::string finish();

  private:
    void end_tests();

    std::string text_, tests_;
    std::size_t test_count_ = 0;
};

/// The recording of a file's bytes as JSON Lines. Throws InputError as RecordingReader does.
std::string recording_as_json(std::string_view bytes, std::string_view name);

/// The other way. Fields that are left out are 0, or empty. Throws InputError, one sentence that
/// names the line, where a line is not JSON, or no record.
std::string recording_of_json(std::string_view text, const std::string& name);

}  // namespace scb::scenes
