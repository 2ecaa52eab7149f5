#pragma once

#include <cstddef>
#include <vector>

namespace scb {

/// Asks the system for large pages for memory that is not yet touched. The first touch of a usual
/// page of 4 KiB takes about as long as building the data in it. This is advice to Linux, where
/// many installations give pages of 2 MiB only on request. It does nothing on other systems, and if
/// no whole page of 2 MiB lies inside.
void prefer_large_pages(void* memory, std::size_t bytes);

/// `vector.resize(count)` of an empty vector, in large pages.
template <class T>
void resize_large(std::vector<T>& vector, std::size_t count) {
    vector.reserve(count);
    prefer_large_pages(vector.data(), count * sizeof(T));
    vector.resize(count);
}

}  // namespace scb
