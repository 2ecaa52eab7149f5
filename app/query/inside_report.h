#pragma once

#include <array>
#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/study/scene_query.h"
#include "core/hierarchy/bodies_inside.h"

namespace scb::app {

/// Which of the two bodies of a query lies inside the other, in frames without contact.
class InsideReport {
  public:
    /// Refers to the query.
    explicit InsideReport(const SceneQuery& query);

    /// Adds a frame in which no triangles intersect. Lists what lies inside the other body there.
    nlohmann::ordered_json add(int frame);
    /// Whether the last frame that was added was judged in full: no part may lie inside a body that
    /// is not closed.
    bool is_judged() const { return !last_[0].not_judged && !last_[1].not_judged; }
    /// Names of the bodies that are not closed: whether something lies inside them is unknown.
    std::vector<std::string> not_closed() const;

    /// "inner lies inside outer in 3 of 5 frames"; empty if no part lies inside. `frames`: the
    /// number of all frames, with and without contact.
    std::string claims(std::size_t frames) const;
    /// A sentence if nothing is known to lie inside but a body is not closed; else empty.
    std::string doubts() const;

  private:
    const std::string& name(std::size_t side) const;

    const SceneQuery& query_;
    BodiesInside bodies_;
    std::array<PartsInside, 2> last_{};
    /// Number of frames in which all or some parts of a body lie inside the other, or could not be
    /// judged.
    std::array<std::size_t, 2> whole_{}, some_{}, not_judged_{};
};

/// "A inside B; parts of B inside A": what InsideReport::add listed.
std::string inside_words(const nlohmann::ordered_json& found);

}  // namespace scb::app
