#pragma once

#include "core/explain/contact_certificate.h"

namespace scb {

/// Whether the farthest points of the two volumes support the certificate, by at least its margin.
/// For a gap, all of A must be before all of B in the direction. For a depth, in some thirty
/// directions, the point must be within both volumes, and B must reach into A by at least the
/// margin; this can refute a depth, but not prove it. False for `touching`, which claims nothing.
///
/// It shares no code with proven_gap, proven_depth and verify, by which a sharpened certificate is
/// made.
bool check_certificate(const Scb& a, const Scb& b, const ContactCertificate& certificate);
bool check_certificate(const Scb2& a, const Scb2& b, const ContactCertificate& certificate);
bool check_certificate(const Ball& a, const Ball& b, const ContactCertificate& certificate);
bool check_certificate(const Obb& a, const Obb& b, const ContactCertificate& certificate);
bool check_certificate(const ConvexShape& a, const ConvexShape& b,
                       const ContactCertificate& certificate);

}  // namespace scb
