#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace scb::render {

/// Does jobs beside the thread that hands them on, in the order they came (with one thread).
///
/// Memory stays flat: push() blocks while `capacity` jobs wait, or while one waits and the new one
/// would bring those that wait above `byte_capacity`. What a thread works on does not wait.
///
/// After an error nothing more is done: what waits is dropped, and push() throws the first error
/// until finish() has thrown it. Then the queue is as new.
class WorkQueue {
  public:
    /// Makes do with fewer threads where the system gives no more; throws std::system_error where
    /// it gives none.
    explicit WorkQueue(std::size_t capacity = 4, std::size_t threads = 1,
                       std::size_t byte_capacity = std::size_t{256} << 20);
    /// Drops what still waits, and waits for what is being done. Call finish() first, or errors go
    /// unnoticed.
    ~WorkQueue();
    WorkQueue(const WorkQueue&) = delete;
    WorkQueue& operator=(const WorkQueue&) = delete;

    /// Takes the job over, which holds about that many bytes; or throws the first error since the
    /// last finish(): what a job threw.
    void push(std::size_t bytes, std::function<void()> job);

    /// Waits until everything is done, or all threads have stopped after an error; throws the first
    /// one. The queue can be used again.
    void finish();

  private:
    struct Job {
        std::size_t bytes;
        std::function<void()> work;
    };

    void work();
    bool has_room_for(std::size_t bytes) const;
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

}  // namespace scb::render
