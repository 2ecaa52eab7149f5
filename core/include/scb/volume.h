#pragma once

#include <concepts>
#include <string_view>

#include "scb/ball.h"
#include "scb/obb.h"
#include "scb/scb.h"
#include "scb/scb2.h"

namespace scb {

/// What a bounding volume type must offer to be the volume of a hierarchy: a plain struct and these
/// free functions. The templates of hierarchy.h are instantiated for the four types below; another
/// one has to be added there and, with how it is fitted, in fit_volumes.cpp.
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

static_assert(Volume<Scb> && Volume<Scb2> && Volume<Ball> && Volume<Obb>);

}  // namespace scb
