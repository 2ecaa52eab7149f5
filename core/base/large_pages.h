#pragma once

#include <cstddef>
#include <vector>

namespace scb {

/// Asks the system for large pages where this memory is not yet touched: a first touch of each of
/// the usual ones of 4 KiB takes about as long as building what a page holds. Advice to Linux,
/// whose pages of 2 MiB wait to be asked for in many installations; elsewhere, and where no whole
/// page of 2 MiB lies inside, nothing happens.
void prefer_large_pages(void* memory, std::size_t bytes);

/// `vector.resize(count)` of an empty vector, in large pages.
template <class T>
void resize_large(std::vector<T>& vector, std::size_t count) {
    vector.reserve(count);
    prefer_large_pages(vector.data(), count * sizeof(T));
    vector.resize(count);
}

}  // namespace scb
