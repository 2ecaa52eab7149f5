#include "render/encode_queue.h"

#include <algorithm>
#include <utility>

#include "render/image_file.h"

namespace scb {

EncodeQueue::EncodeQueue(std::size_t capacity, std::size_t threads)
    : capacity_(std::max<std::size_t>(capacity, 1)) {
    for (std::size_t i = 0; i < std::max<std::size_t>(threads, 1); ++i)
        threads_.emplace_back([this] { work(); });
}

EncodeQueue::~EncodeQueue() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
        waiting_.clear();
    }
    work_or_stop_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}

void EncodeQueue::push(std::filesystem::path path, Image image) {
    push(Job{std::move(path), std::move(image)});
}

void EncodeQueue::push(std::filesystem::path path, IdImage image) {
    push(Job{std::move(path), std::move(image)});
}

void EncodeQueue::push(Job job) {
    std::unique_lock lock(mutex_);
    room_or_idle_.wait(lock, [this] { return waiting_.size() < capacity_ || first_error_; });
    rethrow_first_error();
    waiting_.push_back(std::move(job));
    work_or_stop_.notify_one();
}

void EncodeQueue::finish() {
    std::unique_lock lock(mutex_);
    room_or_idle_.wait(lock, [this] { return (waiting_.empty() || first_error_) && busy_ == 0; });
    rethrow_first_error();
}

void EncodeQueue::rethrow_first_error() {
    if (!first_error_) return;
    waiting_.clear();
    std::rethrow_exception(std::exchange(first_error_, nullptr));
}

void EncodeQueue::work() {
    std::unique_lock lock(mutex_);
    while (true) {
        work_or_stop_.wait(lock, [this] { return stopping_ || !waiting_.empty(); });
        if (stopping_) return;
        const Job job = std::move(waiting_.front());
        waiting_.pop_front();
        ++busy_;
        lock.unlock();
        std::exception_ptr error;
        try {
            write_file_whole(
                job.path,
                std::visit([](const auto& image) { return encode_png(image); }, job.image));
        } catch (...) {
            error = std::current_exception();
        }
        lock.lock();
        --busy_;
        if (error && !first_error_) first_error_ = error;
        room_or_idle_.notify_all();
    }
}

}  // namespace scb
