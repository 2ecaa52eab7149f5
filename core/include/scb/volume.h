#pragma once

#include <concepts>
#include <string_view>

#include "scb/aabb.h"
#include "scb/ball.h"
#include "scb/capsule.h"
#include "scb/kdop.h"
#include "scb/obb.h"
#include "scb/rss.h"
#include "scb/scb.h"
#include "scb/scb2.h"

namespace scb {

/// A bounding volume type that hierarchies can have: a plain struct with these free functions.
/// Templates for volumes are compiled for the types below.
template <class V>
concept Volume = std::default_initializable<V> && std::copyable<V> &&
    requires(const V& c, const Vec3& p) {
    { contains(c, p) } -> std::same_as<bool>;
    { support(c, p) } -> std::same_as<double>;
    { surface_area(c) } -> std::same_as<double>;
    { volume(c) } -> std::same_as<double>;
    { descent_size(c) } -> std::same_as<double>;
    { diameter(c) } -> std::same_as<double>;
    { thickness(c) } -> std::same_as<double>;
};

/// Calls the macro X with each type of volume: the only list of them.
#define SCB_FOR_EACH_VOLUME(X) \
    X(Scb)                     \
    X(Ball)                    \
    X(Obb)                     \
    X(Scb2)                    \
    X(Aabb)                    \
    X(ExactAabb)               \
    X(KDop14)                  \
    X(KDop18)                  \
    X(KDop26)                  \
    X(Rss)                     \
    X(Capsule)

/// Calls the macro X with each kind of volume that a user can choose: its enumerator, its type, and
/// its name on the command line and in files. Several kinds may have one type and differ in their
/// fit.
#define SCB_FOR_EACH_VOLUME_KIND(X)        \
    X(scb, Scb, "scb")                     \
    X(ball, Ball, "ball")                  \
    X(ritter, Ball, "ritter")              \
    X(obb, Obb, "obb")                     \
    X(scb2, Scb2, "scb2")                  \
    X(aabb, Aabb, "aabb")                  \
    X(aabb_exact, ExactAabb, "aabb-exact") \
    X(dop14, KDop14, "dop14")              \
    X(dop18, KDop18, "dop18")              \
    X(dop26, KDop26, "dop26")              \
    X(rss, Rss, "rss")                     \
    X(capsule, Capsule, "capsule")

/// For the next line, which checks that the types of the list are volumes.
#define SCB_IS_VOLUME(V) static_assert(Volume<V>);
SCB_FOR_EACH_VOLUME(SCB_IS_VOLUME)
#undef SCB_IS_VOLUME

}  // namespace scb
