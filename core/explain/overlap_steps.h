#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scb/overlap_options.h"
#include "scb/placement.h"

namespace scb {

/// A term of a step's slack: the distance along its direction, or a part of a volume's extent,
/// which is subtracted.
struct StepTerm {
    enum class Of { distance, a, b };
    Of of = Of::distance;
    std::string name;  ///< with its sign: "d0", "−e0", "+f1·cα", "−r1·sα"
    double value = 0;  ///< with that sign
};

/// One comparison of an overlap test of two volumes, with its numbers. A is the paper's volume 0, B
/// its volume 1, and all is in A's frame; lengths are in the unit of the volumes.
struct OverlapStep {
    Stage stage = Stage::overlapping;  ///< at which the test ends if this step decides
    int line = 0;                ///< of the paper's Figure 8; 0 if the figure has no such line
    std::string formula;         ///< the comparison: "d1 − e1 > r0"
    double left = 0, right = 0;  ///< its two sides
    /// By how much the comparison holds (positive: this step separates A from B by this length) or
    /// fails (negative), minus the placement's margin. For an axis across two edges of boxes, the
    /// margin is divided by the length of their product, since the test compares along this
    /// product. 0 if rounding makes it disagree with `separates`.
    double slack = 0;
    /// Whether the comparison holds, found by the operations of the test itself.
    bool separates = false;
    /// Why the test does not make this comparison: "|n0·n1| = 0.31 is not above a = 0.7". Empty if
    /// it does. The numbers are computed in either case.
    std::string skipped;

    /// The error of this step, in tests that keep errors of the paper; else empty.
    std::string error;

    /// For pictures: along this unit direction from A to B, the step bounds A's extent from its
    /// center by `reach_a`, and B's extent towards A by `reach_b`. The distance of the centers
    /// along it minus both is `slack` plus the margin.
    Vec3 direction = Vec3::UnitZ();
    double reach_a = 0, reach_b = 0;
    /// Their sum is `slack` plus the margin: first the distance, then each volume's extent from its
    /// center outwards.
    std::vector<StepTerm> terms;
    /// For slabs and cylinders, the cylinder's effective radius r_e (equation 11), a part of the
    /// extent of the cylinder's volume.
    double effective_radius = 0;
};

/// A number from which several steps are made.
struct OverlapQuantity {
    std::string_view name;     ///< its symbol in formulas: "cα"
    std::string_view key;      ///< the same in letters and digits: "cosine"
    std::string_view meaning;  ///< "n0·n1"
    double value = 0;
};

/// An overlap test step by step, in its order, with the steps after the one that decided.
struct OverlapSteps {
    std::vector<OverlapQuantity> quantities;
    std::vector<OverlapStep> steps;
    double margin = 0;  ///< of the placement, for rounding, see `slack`

    /// The step that rejected the pair: the first step that is not skipped and separates. None if
    /// the pair passes.
    std::optional<std::size_t> decisive() const;
    /// The result of `overlap`: the decisive step's stage, or overlapping.
    Stage stage() const;
    /// The decisive step, if any; else the step with the greatest slack among those not skipped.
    std::size_t closest() const;
};

/// The steps of the test that the options name, for one pair; not optimized. They use the
/// operations of the tests (Larsson and Akenine-Moller, Section 4, Figure 8; see overlap_figure8,
/// overlap_symmetric and overlap_extents), so the outcome is the same to the last bit. Line numbers
/// and formulas are from Figure 8, for `printed` and `line8` with the errors that these keep.
/// Symbols beyond the paper's: m and h, a slab's middle and half its thickness; ρ(u), the exact
/// extent of an SCB along u.
OverlapSteps overlap_steps(const Scb& a, const Scb& b, const Placement& placed,
                           const OverlapOptions& options);

/// The distance of the centers. The options are ignored for balls and boxes.
OverlapSteps overlap_steps(const Ball& a, const Ball& b, const Placement& placed,
                           const OverlapOptions& = {});

/// The comparisons of overlap_scb2. A double prime marks the second slab, w is the product of the
/// long axes as a unit vector.
OverlapSteps overlap_steps(const Scb2& a, const Scb2& b, const Placement& placed,
                           const OverlapOptions& = {});

/// The 15 separating axes, see overlap_obb. Sides and slack are for unit axes, although the test
/// does not normalize cross products; a and b are the axes of the boxes, ρ as above.
OverlapSteps overlap_steps(const Obb& a, const Obb& b, const Placement& placed,
                           const OverlapOptions& = {});

/// The same axes, all or the first three, see overlap_aabb.
OverlapSteps overlap_steps(const Aabb& a, const Aabb& b, const Placement& placed,
                           const OverlapOptions& = {});
OverlapSteps overlap_steps(const ExactAabb& a, const ExactAabb& b, const Placement& placed,
                           const OverlapOptions& = {});

/// One comparison. -0 becomes 0, and a slack with a wrong sign because of rounding becomes 0.
OverlapStep comparison(Stage stage, int line, std::string formula, double left, double right,
                       double slack, bool separates);

/// Sets the terms, and the extents that they add up to.
void set_terms(OverlapStep& step, std::vector<StepTerm> terms);

/// The terms of the distance d from a slab to the other's center, and of the slab's plane that is
/// `above` it or below: "d0" and "−e0", "−d0" and "+f0".
StepTerm slab_distance(bool above, const std::string& name, double d);
StepTerm slab_plane(bool of_a, bool above, const std::string& name, double at);

/// The step of the balls. `sum` is the sum of the radii and the margin, in the order in which the
/// test adds them.
OverlapStep ball_step(const Vec3& c, double r0, double r1, double margin, double sum);

}  // namespace scb
