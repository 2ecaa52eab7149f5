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

namespace scb::app {

/// What a picture says of a query that ended before it had found everything.
std::string stopped_remark(const TraceFrame& frame);

/// Two bodies of a scene on the GPU, and how they are looked at: what the pictures of a run share.
/// Where the options say that pictures show nothing of the bodies, these stay where they are, and
/// there are names only: titles and file names.
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
    /// The camera as a wish that leaves nothing open, see exact_camera_view.
    scenes::CameraView camera_view(const render::Camera& camera) const;
    /// Where the contact is small in the figure's view, magnifies it, and says in the panel how to
    /// come near.
    void show_small_contact(render::SceneFigure& figure,
                            const std::vector<render::AnyVolume>& region) const;
    bool follows_contact() const { return options_.camera.follows_contact(); }

    const QueryViewOptions& options() const { return options_; }
    const QuerySources& sources() const { return sources_; }
    /// None where the options say that pictures show nothing of the bodies.
    const IdRanges& ids() const { return ids_; }
    const std::optional<render::ComparisonLayout>& layout() const { return layout_; }
    /// What the two queries are called that are compared.
    const std::array<QueryLabel, 2>& labels() const { return labels_; }
    /// "spheres-l1 · SCB · " and what the picture shows.
    std::string title(const std::string& what) const;
    /// The frame, and every option that changes what is drawn but cannot be seen.
    std::string subtitle(std::optional<int> frame = std::nullopt) const;
    /// SCENE_VOLUME_WHAT_OPTIONS_frame-0250; or, of what shows all frames, with these among the
    /// options. Where two queries are compared, their labels are a part of it:
    /// SCENE_scb_corrected-vs-printed_WHAT_frame-0250. `test`: how many tests of it are shown.
    std::string picture_name(const std::string& what, std::optional<int> frame = std::nullopt,
                             std::optional<std::size_t> test = std::nullopt) const;

    /// Where a pixel is to be picked of the picture that was drawn last: adds it to what is
    /// printed, as one line.
    void tell_pick(PictureRun& pictures, const std::string& name, const QueryFrames& frames) const;

    /// Begins the sheet of the pictures of WHAT, where one is asked for.
    void begin_sheet(PictureRun& pictures, const std::string& what,
                     std::optional<SheetRun> planned) const;

  private:
    double aspect() const;
    /// Of a view of the contact: a single small triangle does not fill it.
    double least_radius() const;
    /// The support over all queries and frames of what reaches so far of a body.
    using Reach = std::function<double(const render::QueryBody&, const Vec3& direction)>;
    render::Support support_over_frames(Reach reach) const;
    render::MeshHandle handle_of(const Mesh& mesh) const;

    const QueryViewOptions& options_;
    const QuerySources& sources_;
    render::Renderer& renderer_;
    NamedOptions named_;
    std::optional<render::ComparisonLayout> layout_;
    std::array<QueryLabel, 2> labels_;
    /// By mesh: a recorded one may change from frame to frame.
    mutable std::unordered_map<const Mesh*, render::MeshHandle> meshes_;
    scenes::CameraView camera_view_;
    /// Of both bodies at all frames: what all pictures show.
    Vec3 center_ = Vec3::Zero();
    render::Camera whole_;
    /// Of both bodies at all frames; computed from one frame's volumes after the other.
    render::Support support_;
    IdRanges ids_;
};

}  // namespace scb::app
