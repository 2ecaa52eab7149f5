#pragma once

#include <sys/resource.h>

#include <functional>
#include <string>

#include "scb/error.h"

namespace scb {

/// The message of the InputError that `read` throws if this process may open no more files.
inline std::string refusal_without_files(const std::function<void()>& read) {
    rlimit before{};
    ::getrlimit(RLIMIT_NOFILE, &before);
    const rlimit none{0, before.rlim_max};
    ::setrlimit(RLIMIT_NOFILE, &none);
    try {
        read();
    } catch (const InputError& error) {
        // First: a sanitized program checks the type of `error` by a pipe.
        ::setrlimit(RLIMIT_NOFILE, &before);
        return error.what();
    }
    ::setrlimit(RLIMIT_NOFILE, &before);
    return {};
}

}  // namespace scb
