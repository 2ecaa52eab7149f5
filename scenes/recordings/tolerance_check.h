#pragma once

#include <map>
#include <string>

#include "scenes/recordings/recording_judgement.h"

namespace scb::scenes {

/// Finds the queries whose tolerance is larger than what is to be judged.
class ToleranceCheck {
  public:
    /// Takes a query into the tolerance of its frame. `recording` is at that query.
    void take(const RecordedQueries& recording, const EngineQuery& query,
              const std::map<std::uint32_t, std::string>& body_names, FrameTolerance& tolerance);

    std::uint64_t hidden() const { return hidden_; }        ///< such queries
    const std::string& why() const { return hidden_why_; }  ///< of the first, a clause

  private:
    struct SizeOfItems {
        const NodeTree* tree = nullptr;
        int version = -1;
        double size = 0;
    };
    double size_of_items(std::uint32_t body, const EngineSide& side);

    std::uint64_t hidden_ = 0;
    std::string hidden_why_;
    std::map<std::uint32_t, SizeOfItems> sizes_;  ///< by body
};

}  // namespace scb::scenes
