#include "render/files/encode_queue.h"

#include <utility>

#include "core/platform/output_file.h"

namespace scb::render {

void EncodeQueue::push(std::filesystem::path path, Image image) {
    const std::size_t bytes = image.rgba.size();
    queue_.push(bytes, [this, path = std::move(path), image = std::move(image)] {
        write_file_whole(path, encode_png(image, texts_));
    });
}

void EncodeQueue::push(std::filesystem::path path, IdImage image) {
    const std::size_t bytes = image.ids.size() * sizeof(std::uint32_t);
    queue_.push(bytes, [this, path = std::move(path), image = std::move(image)] {
        write_file_whole(path, encode_png(image, texts_));
    });
}

}  // namespace scb::render
