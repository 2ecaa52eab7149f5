#pragma once

#include "core/analysis/attribution.h"

namespace scb {

/// A pair that passed although no triangles below it intersect, or are as near as the answer.
struct FalsePair {
    int frame = 0;
    PassedPair pair;
    Step test;  ///< its nodes by their numbers, see numbers_of
    /// A lower bound of the gap or depth of the volumes, see ContactCertificate; set by reports.
    double margin = 0;
};

/// A pair that was rejected although its volumes overlap or triangles below it intersect.
struct WronglyRejectedPair {
    int frame = 0;
    WrongRejection rejection;
    Step test;  ///< its nodes by their numbers
};

/// The costliest false pairs of one reason in all added frames. The cost is the number of volume
/// and triangle tests below the pair; equal costs go by frame, then by test. Each pair of nodes
/// appears once, at its worst frame: some are in the way at every frame.
///
/// Weak tests and early pairs are listed if they are not below another of the same reason, loose
/// fits if they are not below any false pair. A pair without tests below it is not listed. If these
/// are too few, parts of them follow, each with at most a quarter of the cost of the pair around
/// it. The pair of the two roots is not listed, since no other hierarchy avoids its test: without
/// contact, parts of that pair are.
class WorstPairs {
  public:
    WorstPairs(PassReason reason, std::size_t most) : reason_(reason), most_(most) {}

    PassReason reason() const { return reason_; }
    void add(const QueryTrace& frame, const Attribution& attribution);
    /// Adds the pairs that another object kept of other frames.
    void add(const std::vector<FalsePair>& outermost, const std::vector<FalsePair>& parts);
    /// The worst one first.
    std::vector<FalsePair> pairs() const;

    /// The kept pairs, worst first: pairs that are not below another, and parts of these.
    const std::vector<FalsePair>& outermost() const { return outermost_; }
    const std::vector<FalsePair>& parts() const { return parts_; }

  private:
    void keep_worst_ones();

    PassReason reason_;
    std::size_t most_;
    std::vector<FalsePair> outermost_, parts_;
};

/// The wrong rejections that miss the most pairs of triangles in all added frames; equal ones by
/// frame, then by test. Each pair of nodes appears once, at its worst frame.
class WorstRejections {
  public:
    explicit WorstRejections(std::size_t most) : most_(most) {}

    void add(const QueryTrace& frame, const Attribution& attribution);
    /// Adds the pairs that another object kept of other frames.
    void add(const std::vector<WronglyRejectedPair>& pairs);
    /// The worst one first.
    const std::vector<WronglyRejectedPair>& pairs() const { return pairs_; }

  private:
    std::size_t most_;
    std::vector<WronglyRejectedPair> pairs_;
};

}  // namespace scb
