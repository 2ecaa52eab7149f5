#pragma once

#include "core/analysis/attribution.h"

namespace scb {

/// A pair that passed although no triangles below it intersect.
struct FalsePair {
    int frame = 0;
    PassedPair pair;
    Step test;
    double margin =
        0;  ///< as of ContactCertificate: gap or depth of the volumes, see sharpen_margin
};

/// Raises the margin to what the sharpened certificate says, as explain() does.
void sharpen_margin(FalsePair& pair, const AnyHierarchy& a, const AnyHierarchy& b,
                    const Pose& b_to_a);

/// A pair that was rejected although its volumes overlap or triangles below it intersect.
struct WronglyRejectedPair {
    int frame = 0;
    WrongRejection rejection;
    Step test;
};

/// The false pairs of one reason that cost the most, of as many frames as are added: by the tests
/// below them (of volumes and of triangles), then by frame and by the order of the tests. Each pair
/// of nodes once, at the frame where it is worst: some are in the way at every frame.
///
/// Of weak tests those that are not within another one; of loose fits those that are not within any
/// false pair. Where these are fewer than asked for, as without contact, where all is within the
/// pair of roots, parts of them follow: each with at most a quarter of the cost of what it is a
/// part of.
class WorstPairs {
  public:
    WorstPairs(PassReason reason, std::size_t most) : reason_(reason), most_(most) {}

    void add(const TraceFrame& frame, const Attribution& attribution);
    /// Adds what others kept of other frames.
    void add(const std::vector<FalsePair>& outermost, const std::vector<FalsePair>& parts);
    /// The worst one first.
    std::vector<FalsePair> pairs() const;

    /// What is kept, the worst first: those that are not within another, and parts of these.
    const std::vector<FalsePair>& outermost() const { return outermost_; }
    const std::vector<FalsePair>& parts() const { return parts_; }

  private:
    void keep_worst_ones();

    PassReason reason_;
    std::size_t most_;
    std::vector<FalsePair> outermost_, parts_;
};

/// The wrong rejections that miss the most pairs of triangles, of as many frames as are added; of
/// equal ones that of the first frame, and there of the first test; each pair of nodes once, at the
/// frame where it is worst.
class WorstRejections {
  public:
    explicit WorstRejections(std::size_t most) : most_(most) {}

    void add(const TraceFrame& frame, const Attribution& attribution);
    /// Adds what others kept of other frames.
    void add(const std::vector<WronglyRejectedPair>& pairs);
    /// The worst one first.
    const std::vector<WronglyRejectedPair>& pairs() const { return pairs_; }

  private:
    std::size_t most_;
    std::vector<WronglyRejectedPair> pairs_;
};

}  // namespace scb
