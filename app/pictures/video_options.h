#pragma once

#include <optional>
#include <string>

namespace scb::app {

class Command;

/// A video of the pictures of a run, beside them.
struct VideoOptions {
    std::string file;  ///< empty: no video
    std::optional<int> frames_per_second;

    bool wanted() const { return !file.empty(); }
    int rate() const { return frames_per_second.value_or(25); }

    /// Refuses invalid options and a video that could not be made, before any work is done; throws
    /// InputError and OutputError. `folder` will be made if it is missing.
    void check(const std::string& folder) const;
};

void add_video_options(const Command& command, VideoOptions& options);

}  // namespace scb::app
