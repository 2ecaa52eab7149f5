#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scb/overlap_options.h"
#include "scb/placement.h"

namespace scb {

/// What a step's slack is made of: the distance along its direction, and what the volumes take away
/// from it.
struct StepTerm {
    enum class Of { distance, a, b };
    Of of = Of::distance;
    std::string name;  ///< with its sign: "d0", "−e0", "+f1·cα", "−r1·sα"
    double value = 0;  ///< with that sign
};

/// One comparison of an overlap test of two volumes, with its numbers. A is the paper's volume 0, B
/// its volume 1, and all is in A's frame; lengths are in the unit of the volumes.
struct OverlapStep {
    Stage stage = Stage::overlapping;  ///< at which the test ends where this step decides
    int line = 0;                ///< of the paper's Figure 8; 0 where the figure has no such line
    std::string formula;         ///< what is compared: "d1 − e1 > r0"
    double left = 0, right = 0;  ///< its two sides
    /// By how much the comparison holds (positive: this step separates A from B, by that much) or
    /// is missed (negative), once the placement's margin is deducted: of an axis across two edges
    /// of boxes, the margin over the length of their product, since the test leaves it along that.
    /// Where rounding makes it disagree with `separates`, it is 0.
    double slack = 0;
    /// Whether the comparison holds, found by the operations of the test itself.
    bool separates = false;
    /// Why the test does not make this comparison: "|n0·n1| = 0.31 is not above a = 0.7". Empty
    /// where it does. Nevertheless, the numbers are those that it would give.
    std::string skipped;

    /// What is wrong with it, in the tests that keep errors of the paper; else empty.
    std::string error;

    /// The same as a picture shows it: along the unit direction, from A to B, the step takes A to
    /// reach no farther than `reach_a` from its center and B no farther than `reach_b` towards A.
    /// What is left of the distance of the centers along the direction is `slack`, and the margin.
    Vec3 direction = Vec3::UnitZ();
    double reach_a = 0, reach_b = 0;
    /// The sum of these is `slack`, and the margin: first the distance, then each volume's reach
    /// from its center outwards.
    std::vector<StepTerm> terms;
    /// Of slabs and cylinders, the cylinder's effective radius r_e (equation 11), which is a part
    /// of the reach of the volume that it is about.
    double effective_radius = 0;
};

/// A number from which several steps are made.
struct OverlapQuantity {
    std::string_view name;     ///< as formulas have it: "cα"
    std::string_view key;      ///< the same in letters and digits: "cosine"
    std::string_view meaning;  ///< "n0·n1"
    double value = 0;
};

/// An overlap test step by step, in its order, with the steps after the one that decided.
struct OverlapSteps {
    std::vector<OverlapQuantity> quantities;
    std::vector<OverlapStep> steps;
    double margin = 0;  ///< of the placement: what the test leaves for rounding, see `slack`

    /// The step that rejected the pair: the first that is made and separates; none: it passes.
    std::optional<std::size_t> decisive() const;
    /// What `overlap` returns: the decisive step's stage, or overlapping.
    Stage stage() const;
    /// Of the steps that are made, the one with the greatest slack; the decisive one where there is
    /// one.
    std::size_t closest() const;
};

/// The steps of the test that the options name, for one pair: not for speed. They are made by the
/// operations of the tests (Larsson and Akenine-Moller, Section 4, Figure 8; see overlap_figure8,
/// overlap_symmetric and overlap_extents), so that the outcome is the same to the last bit. Line
/// numbers are those of Figure 8, and so are the formulas, those of `printed` and `line8` with the
/// errors that these keep. Symbols beyond the paper's: m and h, a slab's middle and half its
/// thickness; ρ(u), how far an SCB itself reaches along u.
OverlapSteps overlap_steps(const Scb& a, const Scb& b, const Placement& placed,
                           const OverlapOptions& options);

/// The distance of the centers. Of balls and boxes the options say nothing.
OverlapSteps overlap_steps(const Ball& a, const Ball& b, const Placement& placed,
                           const OverlapOptions& = {});

/// The comparisons of overlap_scb2. A double prime marks the second slab, w is the product of the
/// long axes as a unit vector.
OverlapSteps overlap_steps(const Scb2& a, const Scb2& b, const Placement& placed,
                           const OverlapOptions& = {});

/// The 15 separating axes, see overlap_obb. Sides and slack are those of unit axes, where the test
/// itself does not normalize cross products; a and b are the axes of the boxes, ρ as above.
OverlapSteps overlap_steps(const Obb& a, const Obb& b, const Placement& placed,
                           const OverlapOptions& = {});

/// The same axes, all or the first three, see overlap_aabb.
OverlapSteps overlap_steps(const Aabb& a, const Aabb& b, const Placement& placed,
                           const OverlapOptions& = {});
OverlapSteps overlap_steps(const ExactAabb& a, const ExactAabb& b, const Placement& placed,
                           const OverlapOptions& = {});

}  // namespace scb
