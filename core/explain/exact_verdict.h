#pragma once

#include "core/explain/contact_certificate.h"
#include "scb/placement.h"

namespace scb {

/// The exact verdict on A, in its own frame, and B, in the frame that `placed` places: the
/// certificate of exact_overlap, in A's frame. If gap or depth is within the placement's margin,
/// the overlap tests cannot decide, and the verdict is that the two touch. Overlap tests are judged
/// by this verdict.
ContactCertificate exact_verdict(const Scb& a, const Scb& b, const Placement& placed);
ContactCertificate exact_verdict(const Scb2& a, const Scb2& b, const Placement& placed);
ContactCertificate exact_verdict(const Ball& a, const Ball& b, const Placement& placed);
ContactCertificate exact_verdict(const Obb& a, const Obb& b, const Placement& placed);
ContactCertificate exact_verdict(const ConvexShape& a, const ConvexShape& b,
                                 const Placement& placed);

/// B in A's frame, for the exact verdict: normals are normalized again, since a pose that is rigid
/// to ten digits may change their lengths.
Scb seen_from_a(const Scb& b, const Placement& placed);
Scb2 seen_from_a(const Scb2& b, const Placement& placed);
Ball seen_from_a(const Ball& b, const Placement& placed);
Obb seen_from_a(const Obb& b, const Placement& placed);
ConvexShape seen_from_a(const ConvexShape& b, const Placement& placed);

}  // namespace scb
