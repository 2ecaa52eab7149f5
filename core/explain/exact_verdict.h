#pragma once

#include "core/explain/contact_certificate.h"
#include "scb/placement.h"

namespace scb {

/// What is so of A, in its own frame, and B, in the one that `placed` says where it is: the proof
/// of exact_overlap, in A's frame. Where gap or depth is within the placement's margin, where the
/// overlap tests themselves cannot tell, the two touch. What a test is worth is judged by this.
ContactCertificate exact_verdict(const Scb& a, const Scb& b, const Placement& placed);
ContactCertificate exact_verdict(const Ball& a, const Ball& b, const Placement& placed);
ContactCertificate exact_verdict(const Obb& a, const Obb& b, const Placement& placed);

/// B in A's frame, as the exact verdict takes it: a normal is made a unit vector again, where a
/// pose that is rigid to ten digits has left it short.
Scb seen_from_a(const Scb& b, const Placement& placed);
Ball seen_from_a(const Ball& b, const Placement& placed);
Obb seen_from_a(const Obb& b, const Placement& placed);

}  // namespace scb
