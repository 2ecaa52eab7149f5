#pragma once

#include <array>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "core/model/body_at_frame.h"
#include "scenes/recordings/recording.h"

namespace scb::scenes {

/// Copies the current bodies of a recording. Trees that did not change are copied once.
class BodyCopies {
  public:
    /// Copies a tree without a body.
    BodyAtFrame copy_tree(RecordedQueries& queries, const std::string& name, std::uint32_t tree);
    /// Copies a body by its number, stretched by its pose. Throws InputError if the pose is
    /// unusable.
    BodyAtFrame copy(RecordedQueries& queries, const Recording& recording, std::uint32_t body);
    /// "OBB", "AABB and hull": the types of all copied volumes.
    std::string volumes() const;

  private:
    std::shared_ptr<const Tree> tree_of(const EngineSide& side, std::uint32_t tree, int version,
                                        const Mat3& stretch);

    /// By tree, volume version, and stretch.
    std::map<std::tuple<std::uint32_t, int, std::array<double, 9>>, std::shared_ptr<const Tree>>
        trees_;
    std::vector<std::string> titles_;
};

/// All bodies of a recording at a frame.
struct RecordedBodies {
    int frame = 0;
    std::vector<BodyAtFrame> bodies;
    std::string volumes;  ///< see TraceEngine
};

/// When a frame is looked at, since bodies may move within it.
enum class Moment {
    first_query,  ///< each body at its first selected query or, without a query, at the end
    end,          ///< after all records of the frame
};

/// Throws InputError if there is no tree yet, or a pose is unusable.
RecordedBodies bodies_at(const Recording& recording, int frame, Moment moment);
/// At the one frame that the list names, or at the first frame if it is empty: at the end or, if
/// queries are selected, at the first of these. Throws InputError.
RecordedBodies bodies_at(const Recording& recording, const std::string& frames);

}  // namespace scb::scenes
