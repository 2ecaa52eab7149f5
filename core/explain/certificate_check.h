#pragma once

#include "core/explain/contact_certificate.h"

namespace scb {

/// Whether the farthest points of the two volumes bear the certificate out, by at least its margin:
/// in the direction of a gap, nothing of A is as far as all of B. Of a depth, the point reaches no
/// farther than either volume, and B no less than the margin into A, in some thirty directions;
/// that can refute a depth, and proves none. What touches claims nothing and is not borne out.
///
/// It shares nothing with proven_gap, proven_depth and verify, by which a sharpened certificate is
/// made.
bool check_certificate(const Scb& a, const Scb& b, const ContactCertificate& certificate);
bool check_certificate(const Scb2& a, const Scb2& b, const ContactCertificate& certificate);
bool check_certificate(const Ball& a, const Ball& b, const ContactCertificate& certificate);
bool check_certificate(const Obb& a, const Obb& b, const ContactCertificate& certificate);
bool check_certificate(const ConvexShape& a, const ConvexShape& b,
                       const ContactCertificate& certificate);

}  // namespace scb
