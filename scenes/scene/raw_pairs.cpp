#include "scenes/scene/raw_pairs.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/text_format.h"
#include "core/platform/input_files.h"
#include "core/platform/json_reader.h"
#include "scb/error.h"

namespace scb::scenes {
namespace {

/// The largest error of a unit vector or a rotation in single precision.
constexpr double largest_defect = 1e-6;
/// Rounding of doubles gets no note.
constexpr double least_noted = 1e-12;

using Notes = std::vector<std::string>;

std::string short_number(double value) { return format("%.9g", value); }

double length_of(const Vec3& v) { return std::sqrt(squared_norm(v)); }

Vec3 read_normal(const JsonPlace& place, Notes& notes) {
    const Vec3 v = read_direction(place);
    const double length = length_of(v);
    if (!(std::abs(length - 1) <= largest_defect))
        refuse(place, "this is not a unit vector: its length is " + short_number(length) +
                          "; divide it by that, and e and f too if they were meant along it.");
    if (std::abs(length - 1) > least_noted)
        notes.push_back(place.path + " has the length " + exact_number(length) +
                        " and was made a unit vector.");
    // Twice, since the error of the first quotient may be larger than allowed for an SCB's normal.
    const Vec3 once = v / length;
    return once / length_of(once);
}

/// The rotation near a matrix that is almost a rotation: each column minus its parts along the
/// columns before, normalized.
Mat3 made_rotation(const Mat3& m) {
    const Vec3 x = m.col(0) / length_of(m.col(0));
    Vec3 y = m.col(1) - dot(x, Vec3(m.col(1))) * x;
    y /= length_of(y);
    Mat3 result;
    result.col(0) = x;
    result.col(1) = y;
    result.col(2) = cross(x, y);
    return result;
}

/// `fault`: the message if the matrix is not a rotation.
Mat3 checked_rotation(const JsonPlace& place, const Mat3& m, const std::string& fault,
                      Notes& notes) {
    const double defect = rigidity_defect({m, Vec3::Zero()});
    if (defect > largest_defect)
        refuse(place, fault +
                          (std::isinf(defect) ? std::string(" (the matrix mirrors or is singular)")
                                              : " (R^T R differs from the identity by " +
                                                    short_number(defect) + ")") +
                          "; give a rotation, with 7 digits or more.");
    if (defect <= least_noted) return m;
    notes.push_back(place.path + " is off a rotation by " + exact_number(defect) +
                    " and was made one.");
    return made_rotation(m);
}

Pose read_pair_pose(const JsonPlace& place, Notes& notes) {
    if (!place.value->is_array() || place.value->size() != 12)
        refuse_value(place, "twelve numbers, [R|t] row by row");
    Pose pose;
    for (std::size_t k = 0; k < 12; ++k) {
        const auto row = static_cast<Eigen::Index>(k / 4),
                   column = static_cast<Eigen::Index>(k % 4);
        (column < 3 ? pose.rotation(row, column) : pose.translation[row]) =
            read_number(element(place, k));
    }
    pose.rotation = checked_rotation(place, pose.rotation, "the pose is not rigid", notes);
    return pose;
}

/// A length whose square does not vanish, or none.
double read_length(const JsonPlace& place) {
    const double length = read_number(place, 0);
    if (length > 0 && length < min_size)
        refuse(place, exact_number(length) + " is too small; at least " + exact_number(min_size) +
                          ", or 0.");
    return length;
}

/// Refuses planes that cut off the whole ball, and moves planes beyond it to its poles.
void check_planes(const JsonPlace& place, double radius, double& upper, double& lower,
                  Notes& notes) {
    const auto e = [&] { return "e = " + exact_number(upper); };
    const auto f = [&] { return "f = " + exact_number(lower); };
    const std::string r = exact_number(radius);
    if (upper < lower)
        refuse(field(place, "e"), e() + " is below " + f() +
                                      "; e is the upper plane: exchange "
                                      "them, or turn the normal.");
    if (lower > radius)
        refuse(field(place, "f"), f() + " is above the ball, whose radius is " + r +
                                      ": the volume holds no point; leave it out.");
    if (upper < -radius)
        refuse(field(place, "e"), e() + " is below the ball, whose radius is " + r +
                                      ": the volume holds no point; leave it out.");
    if (upper > radius) {
        notes.push_back(place.path + "." + e() + " is beyond the ball and was made " + r + ".");
        upper = radius;
    }
    if (lower < -radius) {
        notes.push_back(place.path + "." + f() + " is beyond the ball and was made " +
                        exact_number(-radius) + ".");
        lower = -radius;
    }
}

void read(const JsonPlace& place, Scb& s, Notes& notes) {
    check_fields(place, {"center", "radius", "normal", "e", "f"});
    s.c = read_vec3(field(place, "center"));
    s.r = read_length(field(place, "radius"));
    s.n = read_normal(field(place, "normal"), notes);
    s.e = read_number(field(place, "e"));
    s.f = read_number(field(place, "f"));
    check_planes(place, s.r, s.e, s.f, notes);
}

void read(const JsonPlace& place, Scb2& s, Notes& notes) {
    check_fields(place, {"center", "radius", "slabs"});
    s.c = read_vec3(field(place, "center"));
    s.r = read_length(field(place, "radius"));
    const JsonPlace slabs = field(place, "slabs");
    if (array_size(slabs, "two slabs") != 2) refuse_value(slabs, "two slabs");
    for (std::size_t i = 0; i < 2; ++i) {
        const JsonPlace at = element(slabs, i);
        check_fields(at, {"normal", "e", "f"});
        Slab& slab = s.slabs[i];
        slab.n = read_normal(field(at, "normal"), notes);
        slab.e = read_number(field(at, "e"));
        slab.f = read_number(field(at, "f"));
        check_planes(at, s.r, slab.e, slab.f, notes);
        if (slab.e < 0)
            refuse(field(at, "e"), "e = " + exact_number(slab.e) +
                                       " is below the center, which each of two slabs must hold.");
        if (slab.f > 0)
            refuse(field(at, "f"), "f = " + exact_number(slab.f) +
                                       " is above the center, which each of two slabs must hold.");
        slab.f += 0.0;  // 0 for -0
    }
    Vec3& n = s.slabs[1].n;
    const double cosine = dot(s.slabs[0].n, n);
    const JsonPlace second = field(element(slabs, 1), "normal");
    if (!(std::abs(cosine) <= largest_defect))
        refuse(second, "this is not at right angles to the first normal: their product is " +
                           short_number(cosine) + "; give two that are.");
    if (std::abs(cosine) > least_noted)
        notes.push_back(second.path + " has the product " + short_number(cosine) +
                        " with the first normal and was turned to a right angle.");
    for (int i = 0; i < 2; ++i) {
        n -= dot(s.slabs[0].n, n) * s.slabs[0].n;
        n /= length_of(n);
    }
}

void read(const JsonPlace& place, Ball& ball, Notes&) {
    check_fields(place, {"center", "radius"});
    ball.center = read_vec3(field(place, "center"));
    ball.radius = read_length(field(place, "radius"));
}

void read(const JsonPlace& place, Obb& box, Notes& notes) {
    check_fields(place, {"center", "axes", "half"});
    box.center = read_vec3(field(place, "center"));
    const JsonPlace axes = field(place, "axes");
    if (array_size(axes, "three axes") != 3) refuse_value(axes, "three axes");
    for (std::size_t i = 0; i < 3; ++i)
        box.axes.col(static_cast<Eigen::Index>(i)) = read_vec3(element(axes, i));
    box.axes = checked_rotation(axes, box.axes, "the axes are not a rotation", notes);
    const JsonPlace half = field(place, "half");
    if (array_size(half, "three half lengths") != 3) refuse_value(half, "three half lengths");
    for (std::size_t i = 0; i < 3; ++i)
        box.half[static_cast<Eigen::Index>(i)] = read_length(element(half, i));
}

enum class Kind { scb, two_slabs, ball, box };

/// The kind, from the fields that only this kind has.
Kind kind_of(const JsonPlace& place) {
    check_fields(place, {"center", "radius", "normal", "e", "f", "slabs", "axes", "half"});
    if (has(place, "axes") || has(place, "half")) return Kind::box;
    if (has(place, "slabs")) return Kind::two_slabs;
    if (has(place, "normal") || has(place, "e") || has(place, "f")) return Kind::scb;
    return Kind::ball;
}

const char* words_of(Kind kind) {
    switch (kind) {
        case Kind::scb:
            return "a slab cut ball";
        case Kind::two_slabs:
            return "a ball cut by two slabs";
        case Kind::ball:
            return "a ball";
        case Kind::box:
            break;
    }
    return "a box";
}

Vec3 center_of(const Scb& s) { return s.c; }
Vec3 center_of(const Scb2& s) { return s.c; }
Vec3 center_of(const Ball& ball) { return ball.center; }
Vec3 center_of(const Obb& box) { return box.center; }

/// For two points, only the distance counts.
template <class V>
void check_distance(const JsonPlace& place, const RawPair<V>& pair) {
    if (diameter(pair.a) > 0 || diameter(pair.b) > 0) return;
    const Vec3 apart = transform_point(pair.b_to_a, center_of(pair.b)) - center_of(pair.a);
    const double distance = apart.stableNorm();
    if (distance > 0 && distance < (1 - 1e-9) * min_size)
        refuse(field(field(place, "b"), "center"), "the two points are " + short_number(distance) +
                                                       " apart; at least " +
                                                       exact_number(min_size) + ", or 0.");
}

template <class V>
RawPair<V> read_pair_of(const JsonPlace& place) {
    RawPair<V> pair;
    read(field(place, "a"), pair.a, pair.notes);
    read(field(place, "b"), pair.b, pair.notes);
    if (has(place, "pose")) pair.b_to_a = read_pair_pose(field(place, "pose"), pair.notes);
    check_distance(place, pair);
    return pair;
}

AnyRawPair read_pair(const JsonPlace& place) {
    check_fields(place, {"a", "b", "pose"});
    const Kind a = kind_of(field(place, "a")), b = kind_of(field(place, "b"));
    if (a != b)
        refuse(place, std::string("a is ") + words_of(a) + " and b is " + words_of(b) +
                          "; give two of one kind.");
    if (a == Kind::scb) return read_pair_of<Scb>(place);
    if (a == Kind::two_slabs) return read_pair_of<Scb2>(place);
    if (a == Kind::ball) return read_pair_of<Ball>(place);
    return read_pair_of<Obb>(place);
}

}  // namespace

std::vector<AnyRawPair> parse_raw_pairs(std::string_view json_text, const std::string& file) {
    const nlohmann::json document = parse_json(json_text, file);
    const JsonPlace root{&document, file, ""};
    std::vector<AnyRawPair> pairs;
    if (document.is_object()) {
        pairs.push_back(read_pair(root));
        return pairs;
    }
    const std::size_t count = array_size(root, "a pair of volumes {a, b, pose}, or a list of them");
    pairs.reserve(count);
    for (std::size_t i = 0; i < count; ++i) pairs.push_back(read_pair(element(root, i)));
    return pairs;
}

std::vector<AnyRawPair> read_raw_pairs(const std::string& file) {
    note_input(file);
    return parse_raw_pairs(read_text_file(file, std::size_t{512} << 20), file);
}

}  // namespace scb::scenes
