#include "core/platform/work_queue.h"

#include <algorithm>
#include <utility>

namespace scb {

WorkQueue::WorkQueue(std::size_t capacity, std::size_t threads, std::size_t byte_capacity)
    : capacity_(std::max<std::size_t>(capacity, 1)), byte_capacity_(byte_capacity) {
    threads = std::max<std::size_t>(threads, 1);
    threads_.reserve(threads);
    try {
        while (threads_.size() < threads) threads_.emplace_back([this] { work(); });
    } catch (...) {
        // No thread, or no memory for one: continue with the threads that have started.
        if (threads_.empty()) throw;
    }
}

WorkQueue::~WorkQueue() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
        drop_waiting();
    }
    work_or_stop_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}

void WorkQueue::push(std::size_t bytes, std::function<void()> job) {
    std::unique_lock lock(mutex_);
    room_or_idle_.wait(lock, [&] { return has_room_for(bytes) || first_error_; });
    if (first_error_) std::rethrow_exception(first_error_);
    waiting_.push_back({bytes, std::move(job)});
    waiting_bytes_ += bytes;
    work_or_stop_.notify_one();
}

void WorkQueue::finish() {
    std::unique_lock lock(mutex_);
    room_or_idle_.wait(lock, [this] { return waiting_.empty() && busy_ == 0; });
    if (first_error_) std::rethrow_exception(std::exchange(first_error_, nullptr));
}

bool WorkQueue::has_room_for(std::size_t bytes) const {
    return waiting_.empty() ||
           (waiting_.size() < capacity_ && waiting_bytes_ + bytes <= byte_capacity_);
}

void WorkQueue::drop_waiting() {
    waiting_.clear();
    waiting_bytes_ = 0;
}

void WorkQueue::work() {
    std::unique_lock lock(mutex_);
    while (true) {
        work_or_stop_.wait(lock, [this] { return stopping_ || !waiting_.empty(); });
        if (stopping_) return;
        std::exception_ptr error;
        {
            const Job job = std::move(waiting_.front());
            waiting_.pop_front();
            waiting_bytes_ -= job.bytes;
            ++busy_;
            room_or_idle_.notify_all();
            lock.unlock();
            try {
                job.work();
            } catch (...) {
                error = std::current_exception();
            }
        }
        lock.lock();
        --busy_;
        if (error) {
            drop_waiting();
            if (!first_error_) first_error_ = error;
        }
        room_or_idle_.notify_all();
    }
}

}  // namespace scb
