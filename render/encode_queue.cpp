#include "render/encode_queue.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "render/image_file.h"
#include "render/output_file.h"

namespace scb {

EncodeQueue::EncodeQueue(std::size_t capacity, std::size_t threads, std::size_t byte_capacity)
    : capacity_(std::max<std::size_t>(capacity, 1)), byte_capacity_(byte_capacity) {
    threads = std::max<std::size_t>(threads, 1);
    threads_.reserve(threads);
    try {
        while (threads_.size() < threads) threads_.emplace_back([this] { work(); });
    } catch (const std::system_error&) {
        if (threads_.empty()) throw;
    }
}

EncodeQueue::~EncodeQueue() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
        drop_waiting();
    }
    work_or_stop_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}

void EncodeQueue::push(std::filesystem::path path, Image image) {
    const std::size_t bytes = image.rgba.size();
    push(Job{std::move(path), std::move(image), bytes});
}

void EncodeQueue::push(std::filesystem::path path, IdImage image) {
    const std::size_t bytes = image.ids.size() * sizeof(std::uint32_t);
    push(Job{std::move(path), std::move(image), bytes});
}

void EncodeQueue::push(Job job) {
    std::unique_lock lock(mutex_);
    room_or_idle_.wait(lock, [&] { return has_room_for(job) || first_error_; });
    if (first_error_) std::rethrow_exception(first_error_);
    waiting_bytes_ += job.bytes;
    waiting_.push_back(std::move(job));
    work_or_stop_.notify_one();
}

void EncodeQueue::finish() {
    std::unique_lock lock(mutex_);
    room_or_idle_.wait(lock, [this] { return waiting_.empty() && busy_ == 0; });
    if (first_error_) std::rethrow_exception(std::exchange(first_error_, nullptr));
}

bool EncodeQueue::has_room_for(const Job& job) const {
    return waiting_.empty() ||
           (waiting_.size() < capacity_ && waiting_bytes_ + job.bytes <= byte_capacity_);
}

void EncodeQueue::drop_waiting() {
    waiting_.clear();
    waiting_bytes_ = 0;
}

void EncodeQueue::work() {
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
                write_file_whole(
                    job.path,
                    std::visit([](const auto& image) { return encode_png(image); }, job.image));
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
