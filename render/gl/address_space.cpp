#include "render/gl/address_space.h"

#include <sys/mman.h>
#include <sys/resource.h>

#include <string>

#include "render/gl/context.h"

namespace scb::render {

void require_address_space(std::uint64_t bytes) {
    rlimit limits{};
    if (::getrlimit(RLIMIT_AS, &limits) != 0 || limits.rlim_cur == RLIM_INFINITY) return;
    void* const room =
        ::mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (room == MAP_FAILED)
        throw DrawError("Drawing takes " + std::to_string(bytes >> 20) +
                        " MiB of memory more, which the limit of " +
                        std::to_string(limits.rlim_cur >> 20) +
                        " MiB has no room for; raise it (ulimit -v), or choose a smaller --size.");
    ::munmap(room, bytes);
}

}  // namespace scb::render
