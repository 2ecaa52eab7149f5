#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "core/platform/child_process.h"
#include "core/platform/work_queue.h"
#include "render/files/animation.h"

namespace scb::render {

/// The program that makes videos.
inline constexpr const char* video_program = "ffmpeg";

/// A video of pictures of one size, H.264 in an MP4 file, made in parallel with drawing by the
/// program ffmpeg, which must be on PATH. The same pictures always give the same bytes (with the
/// same ffmpeg and x264). All functions throw OutputError if ffmpeg or the file system fails.
class VideoFile : public Animation {
  public:
    /// `background` fills the column or the row that is added if a side is odd, which the format
    /// does not allow. `patience`: ffmpeg has failed if it reads nothing for this time. Also throws
    /// std::system_error if the system gives no thread.
    VideoFile(std::filesystem::path path, int width, int height, int frames_per_second,
              Rgba8 background, std::chrono::seconds patience = std::chrono::seconds(20));
    /// Without finish() nothing is written.
    ~VideoFile() override;

    void push(Image image) override;
    std::size_t frames() const override { return frames_; }

    /// Waits for ffmpeg. Once it has read all frames, it must end within ten times the patience.
    void finish() override;

  private:
    [[noreturn]] void fail(std::optional<ProcessEnd> end) const;

    std::filesystem::path path_;
    int width_, height_;
    std::chrono::seconds patience_;
    UnnamedFile encoded_;
    ChildProcess encoder_;
    std::size_t frames_ = 0;
    WorkQueue queue_;  ///< destroyed first: it writes to the encoder
};

}  // namespace scb::render
