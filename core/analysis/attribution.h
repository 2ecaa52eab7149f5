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
    /// Why its own test was wasted, see Attribution::wasted_by.
    PassReason within = PassReason::triangles_meet;
    Contact exact = Contact::overlapping;  ///< exact contact of the volumes
    double gap = 0;  ///< lower bound of the gap of disjoint volumes, in the scene's unit
    Work below;      ///< work below the pair; wasted if the pair is false
};

/// A volume test that was wrong to reject: the volumes overlap, or hold triangles that intersect.
struct WrongRejection {
    std::uint32_t test = 0;    ///< index into Steps::volumes
    std::uint64_t missed = 0;  ///< intersecting pairs of triangles below it
    /// Exact contact of the volumes; if not overlapping, `missed` > 0.
    Contact exact = Contact::overlapping;

    friend bool operator==(const WrongRejection&, const WrongRejection&) = default;
};

/// The pairs that the tests of a query passed or wrongly rejected, with reasons.
struct Attribution {
    std::vector<PassedPair> passed;                ///< in the order of the tests
    std::vector<WrongRejection> wrongly_rejected;  ///< in the order of the tests
    /// By test: why it was wasted; triangles_meet if it was not. Of the false pairs above it, early
    /// ones count first, then weak tests, then pairs that are not judged.
    std::vector<PassReason> wasted_by;
    PassCounts counts;
};

/// Facts about the two nodes of a volume test.
struct TestedPair {
    bool known = true;  ///< false: nothing is claimed about the pair
    /// Exact contact of the volumes; touching if unknown. In a query of distances, volumes that are
    /// nearer than the answer overlap.
    Contact exact = Contact::touching;
    double gap = 0;              ///< lower bound of the gap of disjoint volumes
    std::uint64_t contacts = 0;  ///< intersecting pairs of triangles below them
    bool leaves = false;         ///< both nodes are leaves
    bool early = false;          ///< in a query of distances: see PassReason::early
};

/// Attributes every volume test of a query. `pairs`: one for each test of the frame. Operations of
/// other engines and of queries of distances are unknown, and count as 0.
Attribution attribute(const TraceHeader& header, const QueryTrace& frame,
                      std::span<const TestedPair> pairs);

/// Attributes every volume test of a query by the exact verdict on the volumes, with O(N_v)
/// verdicts. The hierarchies must be of the header's volume kind. `contacts`: all intersecting
/// pairs of triangles, in any order, see all_contacts.
Attribution attribute(const AnyHierarchy& a, const AnyHierarchy& b, const TraceHeader& header,
                      const QueryTrace& frame, std::span<const IndexPair> contacts);

/// Repeats the query of a frame with other options.
Collision asked_again(const AnyHierarchy& a, const Mesh& mesh_a, const AnyHierarchy& b,
                      const Mesh& mesh_b, const TraceHeader& header, const QueryTrace& frame,
                      const CollideOptions& options);

/// All intersecting pairs of triangles at the pose of a frame. Repeats the query if it is
/// incomplete, stopped at a level, or used a test that can miss pairs.
std::vector<IndexPair> all_contacts(const AnyHierarchy& a, const Mesh& mesh_a,
                                    const AnyHierarchy& b, const Mesh& mesh_b,
                                    const TraceHeader& header, const QueryTrace& frame);

}  // namespace scb
