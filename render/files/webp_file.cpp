#include "render/files/webp_file.h"

#include <webp/encode.h>
#include <webp/mux.h>

#include <cassert>
#include <utility>

#include "core/platform/output_file.h"

namespace scb::render {

WebpFile::WebpFile(std::filesystem::path path, int width, int height, int frames_per_second)
    : path_(std::move(path)), width_(width), height_(height), rate_(frames_per_second) {
    WebPAnimEncoderOptions options;
    WebPAnimEncoderOptionsInit(&options);
    encoder_.reset(WebPAnimEncoderNew(width, height, &options));
    if (!encoder_) fail("libwebp takes no pictures of this size");
}

void WebpFile::Deleter::operator()(WebPAnimEncoder* encoder) const {
    WebPAnimEncoderDelete(encoder);
}

void WebpFile::fail(const std::string& why) const {
    throw OutputError("Cannot write \"" + path_.string() + "\": " + why +
                      "; use a smaller --size or fewer frames, or a video in .mp4.");
}

int WebpFile::time_of(std::size_t frame) const {
    return static_cast<int>((1000 * frame + static_cast<std::size_t>(rate_) / 2) /
                            static_cast<std::size_t>(rate_));
}

void WebpFile::push(Image image) {
    assert(image.width == width_ && image.height == height_ && "the frames are one size");
    const std::size_t bytes = image.rgba.size();
    queue_.push(bytes, [this, frame = frames_, image = std::move(image)] { encode(frame, image); });
    ++frames_;
}

void WebpFile::encode(std::size_t frame, const Image& image) {
    WebPConfig config;
    WebPPicture picture;
    // Levels above 3 take twice as long for a tenth of the size.
    if (!WebPConfigInit(&config) || !WebPConfigLosslessPreset(&config, 3) ||
        !WebPPictureInit(&picture))
        fail("libwebp is of another version");
    picture.width = width_;
    picture.height = height_;
    picture.use_argb = 1;
    const bool done = WebPPictureImportRGBA(&picture, image.rgba.data(), 4 * width_) != 0 &&
                      WebPAnimEncoderAdd(encoder_.get(), &picture, time_of(frame), &config) != 0;
    WebPPictureFree(&picture);
    if (!done)
        fail(std::string("libwebp says \"") + WebPAnimEncoderGetError(encoder_.get()) + "\"");
}

void WebpFile::finish() {
    queue_.finish();
    WebPData data;
    WebPDataInit(&data);
    if (!WebPAnimEncoderAdd(encoder_.get(), nullptr, time_of(frames_), nullptr) ||
        !WebPAnimEncoderAssemble(encoder_.get(), &data)) {
        WebPDataClear(&data);
        fail(std::string("libwebp says \"") + WebPAnimEncoderGetError(encoder_.get()) + "\"");
    }
    const std::vector<std::uint8_t> bytes(data.bytes, data.bytes + data.size);
    WebPDataClear(&data);
    write_file_whole(path_, bytes);
}

}  // namespace scb::render
