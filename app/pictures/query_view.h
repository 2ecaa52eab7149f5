#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/pictures/picture_run.h"
#include "app/pictures/query_view_options.h"
#include "app/pictures/scene_camera.h"
#include "render/figures/comparison_figure.h"
#include "render/figures/query_body.h"
#include "render/figures/scene_figure.h"

namespace scb::app {

/// What a picture says of a query that ended before it had found everything.
std::string stopped_remark(const TraceFrame& frame);

/// Two bodies of a scene on the GPU, and how they are looked at: what the pictures of a run share.
/// Where the options say that pictures show nothing of the bodies, these stay where they are, and
/// there are names only: titles, file names, what index.json says.
class QueryView {
  public:
    /// `layout`: of the pictures, where two queries are compared.
    QueryView(const QueryViewOptions& options, const QuerySources& sources,
              render::Renderer& renderer,
              std::optional<render::ComparisonLayout> layout = std::nullopt);
    QueryView(const QueryView&) = delete;

    /// Whether there are two queries.
    bool compares() const { return sources_.size() == 2; }
    /// The bodies at a frame, with the hierarchies of one of the queries.
    render::QueryBodies bodies(int frame, std::size_t query = 0) const;
    /// The camera for the view of a picture of the options' size: one for all frames, or, where it
    /// follows the contact and there is one, fitted to `region`.
    render::Camera camera(const std::vector<render::AnyVolume>& region) const;
    /// What that camera looks at: where a scale bar holds.
    Vec3 center(const std::vector<render::AnyVolume>& region) const;
    /// The id of the first of what a picture has beside nodes and triangles.
    std::uint32_t first_free_id() const { return first_free_id_; }
    bool follows_contact() const { return options_.camera.follows_contact(); }

    const std::optional<render::ComparisonLayout>& layout() const { return layout_; }
    /// What the two queries are called that are compared.
    const std::array<QueryLabel, 2>& labels() const { return labels_; }
    /// "spheres-l1 · SCB · " and what the picture shows.
    std::string title(const std::string& what) const;
    /// The frame, and every option that changes what is drawn but cannot be seen.
    std::string subtitle(std::optional<int> frame = std::nullopt) const;
    /// SCENE_VOLUME_WHAT_frame-0250, or without a frame. Where two queries are compared, their
    /// labels are a part of it: SCENE_scb_corrected-vs-printed_WHAT_frame-0250.
    std::string picture_name(const std::string& what,
                             std::optional<int> frame = std::nullopt) const;

    /// What an id of a picture of this frame stands for: {"what": "node", "body": "A", "index":
    /// 412, ...}; null for 0. `query` is that of the view: another's nodes may be others.
    nlohmann::ordered_json what_is(std::uint32_t id, const QueryFrames& frames,
                                   std::size_t query) const;
    /// For each query, the ids of the segments in which its pairs meet: {"first": ..., "count":
    /// ...}, in the order of `scb collide --pairs-out`.
    nlohmann::ordered_json pair_ids(const QueryFrames& frames) const;
    /// Where a pixel is to be picked of the picture that was drawn last: adds it to what is
    /// printed, as one line.
    void tell_pick(PictureRun& pictures, const std::string& name, const QueryFrames& frames) const;

    /// Begins the sheet of the pictures of WHAT, where one is asked for.
    void begin_sheet(PictureRun& pictures, const std::string& what,
                     std::optional<SheetRun> planned) const;

    /// What index.json says of the run: scene, bodies, what was asked, camera, ids.
    nlohmann::ordered_json index_head(const std::string& command) const;
    /// What it says of one picture: the counts of its query, or of both as `queries`; and the
    /// camera, where it moves.
    nlohmann::ordered_json index_entry(const QueryFrames& frames,
                                       const render::Camera& camera) const;
    nlohmann::ordered_json index_entry(const QueryFrames& frames) const;

  private:
    double aspect() const;
    /// How far these nodes' volumes reach, over all queries and frames.
    render::Support support_over_frames(
        const std::array<std::vector<std::uint32_t>, 2>& nodes) const;

    const QueryViewOptions& options_;
    const QuerySources& sources_;
    std::optional<render::ComparisonLayout> layout_;
    std::array<QueryLabel, 2> labels_;
    std::vector<render::MeshHandle> meshes_;
    scenes::CameraView spec_;
    /// Of both bodies at all frames: what all pictures show.
    Vec3 center_ = Vec3::Zero();
    render::Camera whole_;
    /// Of both bodies at all frames; computed from one frame's volumes after the other.
    render::Support support_;
    std::uint32_t first_free_id_ = 1;
};

}  // namespace scb::app
