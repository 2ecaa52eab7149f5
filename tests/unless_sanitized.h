#pragma once

namespace scb {

/// `all`, how much a test tries; or `sanitized` under the sanitizers, where everything takes some
/// ten times as long and what is looked for (a wrong access, an overflow) shows in less.
template <class T>
constexpr T unless_sanitized([[maybe_unused]] T all, [[maybe_unused]] T sanitized) {
#ifdef SCB_SANITIZED
    return sanitized;
#else
    return all;
#endif
}

}  // namespace scb
