#include "render/files/video_file.h"

#include <cassert>
#include <cstdio>
#include <initializer_list>
#include <utility>
#include <vector>

#include "core/platform/output_file.h"
#include "render/files/animation.h"
#include "render/files/webp_file.h"

namespace scb::render {
namespace {

std::string even_size_filter(int width, int height, Rgba8 background) {
    if (width % 2 == 0 && height % 2 == 0) return "";
    char color[16];
    std::snprintf(color, sizeof color, "0x%02X%02X%02X", background.r, background.g, background.b);
    return "pad=" + std::to_string(width + width % 2) + ":" + std::to_string(height + height % 2) +
           ":0:0:" + color + ",";
}

std::vector<std::string> command_for(int width, int height, int frames_per_second,
                                     Rgba8 background) {
    // Errors only: the last line must be the error.
    std::vector<std::string> command = {video_program, "-nostdin", "-hide_banner", "-loglevel",
                                        "error"};
    const auto add = [&command](std::initializer_list<std::string> words) {
        command.insert(command.end(), words);
    };
    add({"-f", "rawvideo", "-pixel_format", "rgb0"});
    add({"-video_size", std::to_string(width) + "x" + std::to_string(height)});
    add({"-framerate", std::to_string(frames_per_second), "-i", "pipe:0"});
    // sRGB as BT.709 in the limited range, which all players support, by arithmetic that is the
    // same on all CPUs.
    add({"-vf", even_size_filter(width, height, background) +
                    "scale=in_range=pc:out_range=tv:out_color_matrix=bt709:"
                    "flags=bicubic+accurate_rnd+full_chroma_int+full_chroma_inp+bitexact,"
                    "format=yuv420p"});
    add({"-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709"});
    add({"-color_range", "tv"});
    // At 14 thin text keeps its edges and flat colors their value. Slower presets save a tenth of a
    // small file.
    add({"-c:v", "libx264", "-preset", "veryfast", "-tune", "animation", "-crf", "14"});
    // The number of threads and the CPU change the bits.
    add({"-threads", "1", "-x264-params", "cpu-independent=1"});
    add({"-fflags", "+bitexact", "-flags:v", "+bitexact", "-map_metadata", "-1"});
    add({"-movflags", "+faststart", "-f", "mp4", "-y", ChildProcess::output_path});
    return command;
}

/// ffmpeg reads no more. The code that waits for it finds out why.
struct EncoderStopped {};

// The time for its messages, once it reads no more.
constexpr std::chrono::seconds time_to_end(2);

}  // namespace

VideoFile::VideoFile(std::filesystem::path path, int width, int height, int frames_per_second,
                     Rgba8 background, std::chrono::seconds patience)
    : path_(std::move(path)),
      width_(width),
      height_(height),
      patience_(patience),
      encoder_(command_for(width_, height_, frames_per_second, background), encoded_, patience),
      queue_(2) {}

VideoFile::~VideoFile() { encoder_.kill(); }

void VideoFile::push(Image image) {
    assert(image.width == width_ && image.height == height_ &&
           "the frames of a video are one size");
    const std::size_t bytes = image.rgba.size();
    try {
        queue_.push(bytes, [this, image = std::move(image)] {
            if (!encoder_.write(image.rgba)) throw EncoderStopped();
        });
    } catch (const EncoderStopped&) {
        fail(encoder_.wait(time_to_end));
    }
    ++frames_;
}

void VideoFile::finish() {
    try {
        queue_.finish();
    } catch (const EncoderStopped&) {
        fail(encoder_.wait(time_to_end));
    }
    // ffmpeg still encodes some frames, and rearranges the file.
    const std::optional<ProcessEnd> end = encoder_.wait(10 * patience_);
    const std::vector<std::uint8_t> bytes = encoded_.bytes();
    // If it could not write the end of the file, it exits with 0 and only prints an error.
    if (end != ProcessEnd{} || bytes.empty() || !encoder_.last_line().empty()) fail(end);
    write_file_whole(path_, bytes);
}

void VideoFile::fail(std::optional<ProcessEnd> end) const {
    std::string what = video_program;
    if (!end)
        what += " did not go on";
    else if (end->by_signal)
        what += " was ended by signal " + std::to_string(end->code);
    else if (end->code != 0)
        what += " failed";
    else
        what += " ended without a whole video";
    if (const std::string line = encoder_.last_line(); !line.empty())
        what += " and said \"" + line + "\"";
    throw OutputError("Cannot write \"" + path_.string() + "\": " + what +
                      "; see that it works here and has libx264, or make no video.");
}

std::unique_ptr<Animation> animation_file(const std::filesystem::path& path, int width, int height,
                                          int frames_per_second, Rgba8 background) {
    if (is_webp_name(path))
        return std::make_unique<WebpFile>(path, width, height, frames_per_second);
    return std::make_unique<VideoFile>(path, width, height, frames_per_second, background);
}

bool is_webp_name(const std::filesystem::path& path) { return path.extension() == ".webp"; }

}  // namespace scb::render
