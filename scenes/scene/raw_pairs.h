#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "scb/ball.h"
#include "scb/obb.h"
#include "scb/pose.h"
#include "scb/scb.h"
#include "scb/scb2.h"

namespace scb::scenes {

/// Two volumes given as numbers, each in a frame of its own; well-formed.
template <class V>
struct RawPair {
    V a, b;
    Pose b_to_a;
    std::vector<std::string> notes{};  ///< the corrections of the numbers, as sentences
};
using AnyRawPair = std::variant<RawPair<Scb>, RawPair<Ball>, RawPair<Obb>, RawPair<Scb2>>;

/// Reads pairs of volumes from JSON: a list of, or one,
///     {"a": VOLUME, "b": VOLUME, "pose": [12 numbers, the rows of [R|t], B's pose in A's frame]}
/// where the pose may be left out, and VOLUME is a slab cut ball, one with two slabs, a ball or a
/// box, both of one kind:
///     {"center": [x, y, z], "radius": r, "normal": [x, y, z], "e": e, "f": f}
///     {"center": [x, y, z], "radius": r, "slabs": [{"normal": [x, y, z], "e": e, "f": f}, the
///     second]}
///     {"center": [x, y, z], "radius": r}
///     {"center": [x, y, z], "axes": [[x, y, z], [x, y, z], [x, y, z]], "half": [x, y, z]}
///
/// Numbers of other engines may have single precision: normals, axes and poses within 1e-6 of unit
/// vectors and rotations are corrected to these, planes beyond the ball are moved to its poles, and
/// a note says so. Throws InputError, naming file, pair and field, for everything else: not JSON,
/// unknown, missing or wrong fields, a normal without length, e < f, a slab that misses its ball, a
/// negative radius or half length, a length below min_size that is not 0 (or such a distance of two
/// points), axes or a pose that is not a rotation, two normals that are not at right angles, one of
/// two slabs without the center. `file` is named in errors.
std::vector<AnyRawPair> parse_raw_pairs(std::string_view json_text, const std::string& file);

/// The same for a file of at most 512 MiB.
std::vector<AnyRawPair> read_raw_pairs(const std::string& file);

}  // namespace scb::scenes
