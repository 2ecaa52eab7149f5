#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/analysis/pass_counts.h"
#include "core/analysis/trace.h"
#include "core/explain/contact_certificate.h"

namespace scb {

/// A volume test that let its pair pass.
struct PassedPair {
    std::uint32_t test = 0;  ///< index into Steps::volumes
    PassReason reason = PassReason::triangles_meet;
    bool leaves = false;  ///< both nodes are leaves
    /// Whether the division of a false pair led here, at whatever distance; or that of one that
    /// passed because of a weak test.
    bool within_false_pair = false, within_weak_test = false;
    Contact exact = Contact::overlapping;  ///< of the volumes
    double gap = 0;                        ///< of disjoint volumes, at least; in the scene's unit
    Work below;                            ///< what came of it: wasted, where the pair is false
};

/// A volume test that rejected volumes which overlap, or which hold triangles that intersect: an
/// error of the test.
struct WrongRejection {
    std::uint32_t test = 0;                ///< index into Steps::volumes
    std::uint64_t missed = 0;              ///< pairs of triangles below it that intersect
    Contact exact = Contact::overlapping;  ///< of the volumes; else, `missed` > 0

    friend bool operator==(const WrongRejection&, const WrongRejection&) = default;
};

/// What the tests of a query passed on, and why.
struct Attribution {
    std::vector<PassedPair> passed;                ///< in the order of the tests
    std::vector<WrongRejection> wrongly_rejected;  ///< in the order of the tests
    PassCounts counts;
};

/// What is known of the two nodes of a volume test.
struct TestedPair {
    bool known = true;                  ///< else nothing is claimed of it
    Contact exact = Contact::touching;  ///< of the volumes; touching where it is not known
    double gap = 0;                     ///< of disjoint ones, at least
    std::uint64_t contacts = 0;         ///< pairs of triangles below them that intersect
    bool leaves = false;                ///< both are leaves
};

/// Attributes every volume test of a query. `pairs`: one for each test of the frame. Of other
/// engines no operations are known.
Attribution attribute(const TraceHeader& header, const TraceFrame& frame,
                      std::span<const TestedPair> pairs);

/// Attributes every volume test of a query of two hierarchies of the header's kind, by the exact
/// verdict on the volumes. `contacts` are all pairs of triangles that intersect, see all_contacts;
/// sorted or not. O(N_v) verdicts.
Attribution attribute(const AnyHierarchy& a, const AnyHierarchy& b, const TraceHeader& header,
                      const TraceFrame& frame, std::span<const IndexPair> contacts);

/// The query of a frame, asked again with other options.
Collision asked_again(const AnyHierarchy& a, const Mesh& mesh_a, const AnyHierarchy& b,
                      const Mesh& mesh_b, const TraceHeader& header, const TraceFrame& frame,
                      const CollideOptions& options);

/// All pairs of triangles that intersect, at the pose of a frame: those that the query found, or,
/// where it ended before it had them all or its test is not sound, those of another query.
std::vector<IndexPair> all_contacts(const AnyHierarchy& a, const Mesh& mesh_a,
                                    const AnyHierarchy& b, const Mesh& mesh_b,
                                    const TraceHeader& header, const TraceFrame& frame);

}  // namespace scb
