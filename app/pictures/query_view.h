#pragma once

#include <functional>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "app/pictures/id_ranges.h"
#include "app/pictures/picture_run.h"
#include "app/pictures/query_view_options.h"
#include "app/pictures/scene_camera.h"
#include "render/figures/comparison_figure.h"
#include "render/figures/query_body.h"
#include "render/figures/scene_figure.h"
#include "render/figures/seeing_direction.h"

namespace scb::app {

/// Text for a query that ended before it had found everything.
std::string stopped_remark(const QueryTrace& frame);

/// The direction of view that was sought, and the frame whose subject most of it shows.
struct SoughtDirection {
    int frame = 0;
    render::SeeingDirection direction;
};

/// Two bodies of a scene on the GPU, with camera and names: common to the pictures of a run. If the
/// pictures show no bodies (Shown::nothing), there are only titles and file names.
class QueryView {
  public:
    /// `layout`: of the pictures, if two queries are compared.
    QueryView(const QueryViewOptions& options, const QuerySources& sources,
              render::Renderer& renderer,
              std::optional<render::ComparisonLayout> layout = std::nullopt);
    QueryView(const QueryView&) = delete;

    /// Whether there are two queries.
    bool compares() const { return sources_.size() == 2; }
    /// Turns the camera to where most of the subject is visible, unless the user or the scene has
    /// chosen a direction. The bodies are as at the frame. With `region`, the camera shows this
    /// region alone.
    void seek(const render::Subject& subject, int frame, const std::vector<AnyVolume>& region = {});
    /// What seek found, if it did.
    const std::optional<SoughtDirection>& sought() const { return sought_; }
    /// The bodies at a frame, with the hierarchies of one of the queries.
    render::QueryBodies bodies(int frame, std::size_t query = 0) const;
    /// The camera for a picture of the options' size: one for all frames; or fitted to `region`, if
    /// looks_closely.
    render::Camera camera(const std::vector<AnyVolume>& region) const;
    /// The point that the camera looks at, where a scale bar is valid.
    Vec3 center(const std::vector<AnyVolume>& region) const;
    /// The complete description of the camera, see exact_camera_view.
    scenes::CameraView camera_view(const render::Camera& camera) const;
    /// Of a close view, adds a small view of the whole. If the contact is small in the figure's
    /// view, magnifies it, and adds a hint for a closer view to the panel.
    void show_place_of_contact(render::SceneFigure& figure,
                               const std::vector<AnyVolume>& region) const;
    /// Whether the camera shows the region alone: if it follows the contact; or, without a camera
    /// asked for, if the region is small in the only picture of a run or in a picture of a sheet.
    /// Other pictures of several frames have one camera, since they may become a video.
    bool looks_closely(const std::vector<AnyVolume>& region) const;
    /// Whether it is the camera for all frames.
    bool is_whole(const render::Camera& camera) const;
    bool follows_contact() const { return options_.camera.follows_contact(); }

    const QueryViewOptions& options() const { return options_; }
    const QuerySources& sources() const { return sources_; }
    /// None with Shown::nothing.
    const IdRanges& ids() const { return ids_; }
    const std::optional<render::ComparisonLayout>& layout() const { return layout_; }
    /// Names of the two compared queries.
    const std::array<QueryLabel, 2>& labels() const { return labels_; }
    /// "spheres-l1 · SCB · " and `what`.
    std::string title(const std::string& what) const;
    /// The frame, and every option that affects the picture but cannot be seen in it.
    std::string subtitle(std::optional<int> frame = std::nullopt) const;
    /// SCENE_VOLUME_WHAT_OPTIONS_frame-0250. Without `frame`, all frames are shown and are among
    /// the options. For two compared queries the name has their labels:
    /// SCENE_scb_corrected-vs-printed_WHAT_frame-0250. `test`: number of its tests shown.
    std::string picture_name(const std::string& what, std::optional<int> frame = std::nullopt,
                             std::optional<std::size_t> test = std::nullopt) const;

    /// If a pixel of the latest picture is to be picked, adds a line about it to the output.
    void tell_pick(PictureRun& pictures, const std::string& name, const QueryFrames& frames) const;

    /// Begins the sheet of the pictures of `what`, if asked for.
    void begin_sheet(PictureRun& pictures, const std::string& what,
                     std::optional<SheetRun> planned) const;

  private:
    /// seek, for the contact of a frame that is shown.
    void seek_contact();
    /// Fits the camera that shows everything.
    void place_camera();
    double aspect() const;
    /// The least radius of a view of the contact.
    double least_radius() const;
    /// The region, and so much about it that a single small triangle does not fill the view.
    std::vector<AnyVolume> near_contact(std::vector<AnyVolume> region) const;
    /// The support over all queries and frames; `reach` is the extent of a body in a direction.
    using Reach = std::function<double(const render::QueryBody&, const Vec3& direction)>;
    render::Support support_over_frames(Reach reach) const;
    render::MeshHandle handle_of(const Mesh& mesh) const;

    const QueryViewOptions& options_;
    const QuerySources& sources_;
    render::Renderer& renderer_;
    NamedOptions named_;
    std::optional<render::ComparisonLayout> layout_;
    std::array<QueryLabel, 2> labels_;
    /// By mesh, since the mesh of a recorded body may change between frames.
    mutable std::unordered_map<const Mesh*, render::MeshHandle> meshes_;
    scenes::CameraView camera_view_;
    std::optional<SoughtDirection> sought_;
    /// Of both bodies at all frames.
    Vec3 center_ = Vec3::Zero();
    render::Camera whole_;
    /// Of both bodies at all frames; computed from the volumes of one frame at a time.
    render::Support support_;
    /// What the camera holds: the support, or a part of it.
    render::Support held_;
    IdRanges ids_;
};

}  // namespace scb::app
