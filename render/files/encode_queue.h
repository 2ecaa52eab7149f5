#pragma once

#include <filesystem>
#include <utility>
#include <vector>

#include "core/platform/work_queue.h"
#include "render/files/image.h"
#include "render/files/image_file.h"

namespace scb::render {

/// Encodes pictures as PNG and writes them in parallel with drawing, with the order, the bounds and
/// the errors (OutputError) of a WorkQueue.
class EncodeQueue {
  public:
    explicit EncodeQueue(std::size_t capacity = 4, std::size_t threads = 1,
                         std::size_t byte_capacity = std::size_t{256} << 20)
        : queue_(capacity, threads, byte_capacity) {}

    /// Sets the texts of all files; call it before the first picture.
    void set_texts(std::vector<PngText> texts) { texts_ = std::move(texts); }

    /// Takes the picture over.
    void push(std::filesystem::path path, Image image);
    void push(std::filesystem::path path, IdImage image);

    /// Waits until everything is written.
    void finish() { queue_.finish(); }

  private:
    std::vector<PngText> texts_;  ///< declared before the queue, whose threads read it to their end
    WorkQueue queue_;
};

}  // namespace scb::render
