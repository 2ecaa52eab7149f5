#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace scb {

/// Runs jobs in parallel with the calling thread, in the order of push() (with one thread).
///
/// Memory stays bounded: push() blocks while `capacity` jobs wait, or while a job waits and the new
/// one would bring the waiting jobs above `byte_capacity`. Running jobs do not count as waiting.
///
/// After an error no further job runs: waiting jobs are dropped, and push() throws the first error
/// until finish() has thrown it. Then the queue can be used again.
class WorkQueue {
  public:
    /// Uses fewer threads if the system gives no more; throws std::system_error if it gives none.
    explicit WorkQueue(std::size_t capacity = 4, std::size_t threads = 1,
                       std::size_t byte_capacity = std::size_t{256} << 20);
    /// Drops waiting jobs, and waits for running jobs. Call finish() first, or errors go unnoticed.
    ~WorkQueue();
    WorkQueue(const WorkQueue&) = delete;
    WorkQueue& operator=(const WorkQueue&) = delete;

    /// Takes over the job, which holds about `bytes` bytes. Throws the first exception of a job
    /// since the last finish().
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

}  // namespace scb
