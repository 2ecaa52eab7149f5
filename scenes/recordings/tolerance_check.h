#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "scenes/recordings/recording_judgement.h"

namespace scb::scenes {

/// Counts the triangles, and the leaf volumes of objects, that are smaller than the tolerance: what
/// an engine says of these is not judged.
class ToleranceCheck {
  public:
    /// Takes a query into the tolerance of its frame. `recording` is at that query.
    void take(const RecordedQueries& recording, const EngineQuery& query,
              const std::map<std::uint32_t, std::string>& body_names, FrameTolerance& tolerance);
    /// The same of the trees that no body has, at the end of a frame.
    void take_trees(RecordedQueries& recording, FrameTolerance& tolerance);

    /// The most that were hidden in any frame, of how many, and why: a clause on the first.
    std::uint64_t hidden() const;
    std::uint64_t of() const;
    const std::string& why() const { return why_; }

  private:
    struct Items {
        const EngineNodes* tree = nullptr;
        int version = -1;
        /// Size and reach of each triangle or, of objects, of each leaf volume; points are left
        /// out. Ascending by size. All triangles have the reach 0: their tolerance is the same.
        std::vector<std::pair<double, double>> sizes;
        std::uint64_t hidden = 0;
    };
    Items& items_of(std::map<std::uint32_t, Items>& all, std::uint32_t number,
                    const EngineSide& side);
    /// `tolerance_at` gives the tolerance of an item by its reach.
    void look(Items& items, const EngineSide& side, const std::string& name,
              const std::function<double(double)>& tolerance_at, int frame,
              const std::string& cause, FrameTolerance& of_frame);

    std::string why_;
    std::map<std::uint32_t, Items> of_bodies_, of_trees_;  ///< by number
};

}  // namespace scb::scenes
