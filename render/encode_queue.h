#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <filesystem>
#include <mutex>
#include <thread>
#include <variant>
#include <vector>

#include "render/image.h"

namespace scb {

/// Encodes pictures as PNG and writes them beside the drawing, in the order they came (with one
/// thread). At most `capacity` pictures wait, so memory stays flat; push() blocks only while that
/// many do.
class EncodeQueue {
  public:
    explicit EncodeQueue(std::size_t capacity = 4, std::size_t threads = 1);
    /// Drops what still waits. Call finish() first, or errors go unnoticed.
    ~EncodeQueue();
    EncodeQueue(const EncodeQueue&) = delete;
    EncodeQueue& operator=(const EncodeQueue&) = delete;

    /// Takes the picture over. Throws the first error so far (OutputError), and then takes nothing.
    void push(std::filesystem::path path, Image image);
    void push(std::filesystem::path path, IdImage image);

    /// Waits until everything is written; throws the first error (OutputError). The queue can be
    /// used again.
    void finish();

  private:
    struct Job {
        std::filesystem::path path;
        std::variant<Image, IdImage> image;
    };

    void push(Job job);
    void work();
    void rethrow_first_error();

    const std::size_t capacity_;
    std::mutex mutex_;
    std::condition_variable room_or_idle_;
    std::condition_variable work_or_stop_;
    std::deque<Job> waiting_;
    std::size_t busy_ = 0;
    bool stopping_ = false;
    std::exception_ptr first_error_;
    std::vector<std::thread> threads_;
};

}  // namespace scb
