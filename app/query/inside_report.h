#pragma once

#include <array>
#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/query/scene_query.h"
#include "core/hierarchy/bodies_inside.h"

namespace scb::app {

/// Which of the two bodies of a query lies inside the other, at the frames without contact.
class InsideReport {
  public:
    /// Refers to the query.
    explicit InsideReport(const SceneQuery& query);

    /// A frame at which no triangles intersect; a list of what lies inside the other body there.
    nlohmann::ordered_json add(int frame);
    /// Bodies that are not closed, of which it is therefore not known what lies inside them.
    std::vector<std::string> not_closed() const;

    /// "inner lies inside outer in 3 of 5 frames"; empty where no part lies inside. `frames`: how
    /// many there are, with and without contact.
    std::string claims(std::size_t frames) const;
    /// A sentence where nothing lies inside as far as is known, but a body that is not closed keeps
    /// something unknown; else empty.
    std::string doubts() const;

  private:
    const std::string& name(std::size_t side) const;

    const SceneQuery& query_;
    BodiesInside bodies_;
    std::array<PartsInside, 2> last_{};
    /// In how many frames all or some of the parts of a body lie inside the other, or may.
    std::array<std::size_t, 2> whole_{}, some_{}, not_judged_{};
};

}  // namespace scb::app
