#pragma once

#include <optional>

#include "core/explain/contact_certificate.h"
#include "core/judge/engine_query.h"

namespace scb {

/// How a recorded test of two volumes compares with the exact verdict on the recorded volumes.
enum class TestVerdict : std::uint8_t {
    right,
    false_positive,  ///< passed disjoint volumes
    wrong,           ///< rejected overlapping volumes
    unjudged,        ///< no proven verdict, for example because a node is unknown or has no volume
};

/// The verdict on the volumes of two nodes that count as overlapping if they are nearer than
/// `reach`. None if the volumes are smaller than the tolerance, or a node does not exist.
std::optional<ContactCertificate> certificate_of(const EngineQuery& query, const Pose& b_to_a,
                                                 IndexPair nodes, double reach);

/// The verdict on a test that passed or rejected the volumes of this certificate.
TestVerdict verdict_of(const std::optional<ContactCertificate>& certificate, bool passed);

}  // namespace scb
