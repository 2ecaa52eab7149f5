#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "scenes/recordings/recording_judgement.h"

namespace scb::scenes {

/// Counts the triangles, and the leaf volumes of objects, that are not larger than the tolerance:
/// tests of these are not judged.
class ToleranceCheck {
  public:
    /// Adds a query to the tolerance of its frame. `recording` must be at this query.
    void take(const RecordedQueries& recording, const EngineQuery& query,
              const std::map<std::uint32_t, std::string>& body_names, FrameTolerance& tolerance);
    /// The same for trees without a body, at the end of a frame.
    void take_trees(RecordedQueries& recording, FrameTolerance& tolerance);

    /// The largest numbers of hidden items in any frame; the number of all items; the cause of the
    /// first, as a clause.
    std::uint64_t hidden() const;
    std::uint64_t of() const;
    const std::string& why() const { return why_; }

  private:
    struct Items {
        const EngineNodes* tree = nullptr;
        int version = -1;
        /// Size and reach of each triangle or, for objects, of each leaf volume. Ascending by size,
        /// without points. Triangles have reach 0, since all have the same tolerance.
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
