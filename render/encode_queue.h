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
/// thread).
///
/// Memory stays flat: push() blocks while `capacity` pictures wait, or while one waits and the new
/// one would bring those that wait above `byte_capacity`. What a thread works on does not wait.
///
/// After an error nothing more is written: what waits is dropped, and push() throws the first error
/// until finish() has thrown it. Then the queue is as new.
class EncodeQueue {
  public:
    /// Makes do with fewer threads where the system gives no more; throws std::system_error where
    /// it gives none.
    explicit EncodeQueue(std::size_t capacity = 4, std::size_t threads = 1,
                         std::size_t byte_capacity = std::size_t{256} << 20);
    /// Drops what still waits. Call finish() first, or errors go unnoticed.
    ~EncodeQueue();
    EncodeQueue(const EncodeQueue&) = delete;
    EncodeQueue& operator=(const EncodeQueue&) = delete;

    /// Takes the picture over; or throws the first error since the last finish() (OutputError).
    void push(std::filesystem::path path, Image image);
    void push(std::filesystem::path path, IdImage image);

    /// Waits until everything is written, or all threads have stopped after an error; throws the
    /// first one (OutputError). The queue can be used again.
    void finish();

  private:
    struct Job {
        std::filesystem::path path;
        std::variant<Image, IdImage> image;
        std::size_t bytes;
    };

    void push(Job job);
    void work();
    bool has_room_for(const Job& job) const;
    void drop_waiting();

    const std::size_t capacity_;
    const std::size_t byte_capacity_;
    std::mutex mutex_;
    std::condition_variable room_or_idle_;
    std::condition_variable work_or_stop_;
    std::deque<Job> waiting_;
    std::size_t waiting_bytes_ = 0;
    std::size_t busy_ = 0;
    bool stopping_ = false;
    std::exception_ptr first_error_;
    std::vector<std::thread> threads_;
};

}  // namespace scb
