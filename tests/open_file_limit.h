#pragma once

#include <sys/resource.h>

#include <functional>
#include <string>

#include "scb/error.h"

namespace scb {

/// The message of the InputError that `read` throws if this process may open no more files. With
/// files, `read` must succeed.
inline std::string refusal_without_files(const std::function<void()>& read) {
    // A sanitized program checks the type of an object by a pipe, but each type only once.
    read();
    rlimit before{};
    ::getrlimit(RLIMIT_NOFILE, &before);
    const rlimit none{0, before.rlim_max};
    ::setrlimit(RLIMIT_NOFILE, &none);
    try {
        read();
    } catch (const InputError& error) {
        // Before the type of `error` is checked.
        ::setrlimit(RLIMIT_NOFILE, &before);
        return error.what();
    }
    ::setrlimit(RLIMIT_NOFILE, &before);
    return {};
}

}  // namespace scb
