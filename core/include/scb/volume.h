#pragma once

#include <concepts>
#include <string_view>

#include "scb/aabb.h"
#include "scb/ball.h"
#include "scb/obb.h"
#include "scb/scb.h"
#include "scb/scb2.h"

namespace scb {

/// What a bounding volume type must offer to be the volume of a hierarchy: a plain struct and these
/// free functions. Templates for volumes are compiled for the types below.
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
#define SCB_FOR_EACH_VOLUME(X) X(Scb) X(Scb2) X(Ball) X(Obb) X(Aabb) X(ExactAabb)

#define SCB_IS_VOLUME(V) static_assert(Volume<V>);
SCB_FOR_EACH_VOLUME(SCB_IS_VOLUME)
#undef SCB_IS_VOLUME

}  // namespace scb
