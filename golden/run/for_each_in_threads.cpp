#include "golden/run/for_each_in_threads.h"

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace scb::golden {

void for_each_in_threads(std::size_t count, std::size_t threads,
                         const std::function<void(std::size_t)>& work,
                         const std::function<bool()>& step) {
    std::atomic<std::size_t> next = 0;
    std::mutex stepping;
    std::exception_ptr error;
    const auto run = [&] {
        for (std::size_t i = next++; i < count; i = next++) {
            try {
                work(i);
                const std::lock_guard lock(stepping);
                if (!step()) next = count;
            } catch (...) {
                const std::lock_guard lock(stepping);
                if (!error) error = std::current_exception();
                next = count;
                return;
            }
        }
    };
    {
        std::vector<std::jthread> others;
        for (std::size_t i = 1; i < threads && i < count; ++i) others.emplace_back(run);
        run();
    }
    if (error) std::rethrow_exception(error);
}

}  // namespace scb::golden
