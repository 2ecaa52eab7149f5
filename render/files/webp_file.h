#pragma once

#include <memory>

#include "core/platform/work_queue.h"
#include "render/files/animation.h"

struct WebPAnimEncoder;

namespace scb::render {

/// An endless animation for browsers: lossless WebP, by libwebp. The same pictures always give the
/// same bytes (with the same libwebp).
class WebpFile : public Animation {
  public:
    WebpFile(std::filesystem::path path, int width, int height, int frames_per_second);

    void push(Image image) override;
    std::size_t frames() const override { return frames_; }
    void finish() override;

  private:
    [[noreturn]] void fail(const std::string& why) const;
    /// The time at which a frame begins, in milliseconds.
    int time_of(std::size_t frame) const;
    void encode(std::size_t frame, const Image& image);

    std::filesystem::path path_;
    int width_, height_, rate_;
    struct Deleter {
        void operator()(WebPAnimEncoder* encoder) const;
    };
    std::unique_ptr<WebPAnimEncoder, Deleter> encoder_;
    std::size_t frames_ = 0;
    WorkQueue queue_{2};  ///< declared last, so its thread ends before the encoder does
};

}  // namespace scb::render
