#pragma once

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/analysis/trace.h"
#include "core/hierarchy/volume_tree.h"
#include "scenes/recordings/recorded_queries.h"
#include "scenes/recordings/recording_input.h"
#include "scenes/scene/scene.h"

namespace scb::scenes {

/// A body at a frame, with the hierarchy that it has there, whoever built that.
struct BodyAtFrame {
    std::string name;
    std::shared_ptr<const Mesh> mesh;  ///< without triangles where items are objects
    std::shared_ptr<const VolumeTree> tree;
    Pose pose;
    std::uint32_t number = 0;  ///< of the tree, in a recording
};

/// What a recording has of meshes, bodies and poses, as a scene: of meshes that change, the first.
/// Bodies of trees without a mesh have one without triangles; where there are no bodies, the trees
/// are. Its file is the recording. Throws InputError as RecordedQueries does, where it has no tree,
/// and where a mesh changes though that is refused.
enum class ChangingMeshes { allowed, refused };
Scene scene_of_recording(std::string_view bytes, const std::string& path, ChangingMeshes changing);

/// All bodies of a recording at a frame.
struct RecordedBodies {
    Scene scene;
    int frame = 0;
    std::vector<BodyAtFrame> bodies;
    std::string engine, volumes;  ///< see TraceEngine
};

/// At the one frame that the list names; where it is empty, at the first. Throws InputError.
RecordedBodies bodies_of_recording(const std::string& path, const std::string& frames);
RecordedBodies bodies_of_recording(const std::string& path, int frame);

/// The queries of two bodies of a recording as traces have them, frame by frame, and what there is
/// of the bodies at each of these frames.
class RecordedTrace {
  public:
    /// `bodies` names two, "A,B", or is empty where the recording has queries of two only; `frames`
    /// is a list, see frames_among, or auto_frames: the first with the most pairs. Throws
    /// InputError.
    RecordedTrace(const std::string& path, const std::string& bodies, const std::string& frames)
        : RecordedTrace(recording_bytes(path), path, bodies, frames) {}
    /// The same of bytes that are the file's.
    RecordedTrace(std::string bytes, const std::string& path, const std::string& bodies,
                  const std::string& frames);
    RecordedTrace(const RecordedTrace&) = delete;

    const TraceHeader& header() const { return header_; }
    const Scene& scene() const { return scene_; }
    /// Indices of Scene::bodies.
    const std::array<std::size_t, 2>& sides() const { return sides_; }
    /// Ascending.
    const std::vector<int>& frames() const { return frames_; }
    /// One of the two at one of these frames.
    const BodyAtFrame& body(std::size_t side, int frame) const;
    /// Whether it tells of pairs, or of tests of items, anywhere.
    bool tells_results() const {
        return summary_.tells_pairs || summary_.pairs + summary_.item_tests > 0;
    }
    /// How many tests of volumes there are in it.
    std::uint64_t test_count(int frame) const { return test_counts_.at(frame); }
    /// The first query of them at one of these frames; valid until the next call. They must be
    /// asked for ascending.
    const TraceFrame& frame(int number);

  private:
    bool is_wanted(const RecordedQueries& queries) const;
    /// Chooses bodies and frames.
    void choose(const std::string& bodies, const std::string& frames);
    /// Reads what there is of the bodies.
    void read_bodies();

    std::string path_, bytes_;
    RecordingSummary summary_;
    Scene scene_;
    std::array<std::size_t, 2> sides_{};
    std::array<std::uint32_t, 2> numbers_{};  ///< of the bodies in the recording
    std::vector<int> frames_;
    TraceHeader header_;
    std::map<std::uint8_t, Stage> stages_;
    std::map<int, std::array<BodyAtFrame, 2>> bodies_;
    std::map<int, std::uint64_t> test_counts_;
    std::unique_ptr<RecordedQueries> queries_;
    TraceFrame frame_;
};

}  // namespace scb::scenes
