#include "app/pictures/query_view.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <set>
#include <unordered_map>
#include <utility>

#include "app/pictures/query_settings.h"
#include "app/report/scene_report.h"
#include "core/base/text_format.h"
#include "render/figures/figure_words.h"
#include "render/figures/pairs_figure.h"
#include "render/figures/volume_colors.h"
#include "scb/level_cover.h"

namespace scb::app {
namespace {

/// A region whose extent is below this part of the view's is small in it.
constexpr double small_in_view = 1.0 / 6;
/// A region whose extent is at least this part is not seen closer with twice its radius about it.
constexpr double wide_in_view = 0.5;

/// The nodes whose volumes the camera has to show: some that cover the mesh closely, or all leaves.
/// If volumes are drawn, all of the upper levels, since a volume may stick out of its parent;
/// deeper volumes stick out little.
std::vector<std::uint32_t> held_nodes(const Tree& tree, Shown shown) {
    constexpr std::uint32_t levels = 6;
    const TreeShape& shape = tree.shape();
    std::vector<std::uint32_t> nodes;
    if (shown == Shown::volumes) {
        for (std::uint32_t node = 0; node < shape.size(); ++node)
            if (shape.is_reachable(node) && shape.depths[node] <= levels) nodes.push_back(node);
    } else {
        nodes = level_cover(shape, shown == Shown::leaves ? leaf_level : static_cast<int>(levels));
    }
    std::erase_if(nodes, [&tree](std::uint32_t node) { return !tree.has_volume(node); });
    return nodes;
}

/// The nodes of each tree, found once.
class HeldNodes {
  public:
    explicit HeldNodes(Shown shown) : shown_(shown) {}
    const std::vector<std::uint32_t>& of(const Tree& tree) {
        const auto [nodes, added] = of_.try_emplace(&tree);
        if (added) nodes->second = held_nodes(tree, shown_);
        return nodes->second;
    }

  private:
    Shown shown_;
    std::unordered_map<const Tree*, std::vector<std::uint32_t>> of_;  // lookups only
};

/// The depth range for everything, but with the point that the camera looks at: of a large floor
/// and a small contact, the floor alone would set a near plane behind the contact.
void set_range_about(render::Camera& camera, const render::Support& everything,
                     const Vec3& center) {
    render::set_depth_range(camera, everything);
    const double eye = dot(Vec3(camera.position - center), Vec3(camera.axes.col(2)));
    if (eye > 0) camera.near_distance = std::min(camera.near_distance, eye / 8);
}

/// Of two compared queries, keeps in `query` the pairs that only one of them found. Without such
/// pairs it returns false, and keeps all.
bool keep_pairs_of_one(QueryTrace& query, const QueryTrace& other) {
    const std::vector<IndexPair>&a = query.found.pairs, &b = other.found.pairs;
    std::vector<IndexPair> of_one;
    std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(),
                                  std::back_inserter(of_one));
    if (of_one.empty()) return false;
    query.found.pairs = std::move(of_one);
    return true;
}

}  // namespace

std::string stopped_remark(const QueryTrace& frame) {
    return "stopped at " + render::count_text(frame.found.pairs.size()) +
           (frame.found.pairs.size() == 1 ? " pair" : " pairs");
}

QueryView::QueryView(const QueryViewOptions& options, const QuerySources& sources,
                     render::Renderer& renderer, std::optional<render::ComparisonLayout> layout)
    : options_(options),
      sources_(sources),
      renderer_(renderer),
      named_(options.named),
      layout_(layout) {
    if (compares()) labels_ = query_labels(sources[0].header(), sources[1].header());
    name_query(named_, sources.front(), sources.back());
    if (options.shown != Shown::nothing) name_view(named_, options.picture, options.camera);
    name_picture(named_, options.picture);
    if (options.shown == Shown::nothing) return;
    const QuerySource& source = sources.front();
    ids_ = id_ranges(sources);
    camera_view_ = camera_view_for(options.camera, source.scene());
    const auto nodes = std::make_shared<HeldNodes>(options.shown);
    const Reach of_volumes = [nodes](const render::QueryBody& body, const Vec3& direction) {
        double most = -std::numeric_limits<double>::infinity();
        for (const std::uint32_t node : nodes->of(*body.tree))
            most = std::max(most, reach(render::volume_of(body, node), direction));
        // Trees without volumes: use the mesh.
        return std::isfinite(most) ? most : mesh_reach(body, direction);
    };
    support_ = support_over_frames(of_volumes);
    held_ = support_;
    if (options.held_part < 1)
        held_ = render::support_between(
            support_over_frames([of_volumes](const render::QueryBody& body, const Vec3& direction) {
                return body.mesh->triangles.empty() ? of_volumes(body, direction)
                                                    : mesh_reach(body, direction);
            }),
            support_, options.held_part);
    place_camera();
    if (options.seeks_contact) seek_contact();
}

void QueryView::place_camera() {
    center_ = render::center_of(held_);
    whole_ = camera_for(camera_view_, held_, aspect());
    render::set_depth_range(whole_, support_);
}

void QueryView::seek(const render::Subject& subject, int frame,
                     const std::vector<AnyVolume>& region) {
    if (!options_.camera.leaves_direction_open(sources_.front().scene())) return;
    const render::QueryBodies at_frame = bodies(frame);
    // Objects of another engine have volumes only.
    const bool has_meshes =
        !at_frame[0].mesh->triangles.empty() && !at_frame[1].mesh->triangles.empty();
    const render::Support of_meshes = [&at_frame](const Vec3& direction) {
        return std::max(mesh_reach(at_frame[0], direction), mesh_reach(at_frame[1], direction));
    };
    const render::Support whole = has_meshes ? of_meshes : support_;
    const render::Support shown = region.empty() ? whole : render::support_of(region);
    sought_ = {frame,
               render::seeing_direction(
                   renderer_, subject, aspect(), {camera_view_.azimuth, camera_view_.elevation},
                   [&](double azimuth, double elevation) {
                       scenes::CameraView wish = camera_view_;
                       wish.azimuth = azimuth;
                       wish.elevation = elevation;
                       render::Camera camera = camera_for(wish, shown, aspect());
                       set_range_about(camera, whole, render::center_of(shown));
                       return camera;
                   })};
    camera_view_.azimuth = sought_->direction.azimuth;
    camera_view_.elevation = sought_->direction.elevation;
    place_camera();
}

void QueryView::seek_contact() {
    const QuerySource& source = sources_.front();
    if (!options_.camera.leaves_direction_open(source.scene())) return;
    // One direction for all pictures of a run: by the frame with the most pairs of three.
    const std::vector<int>& frames = source.frames();
    std::optional<QueryTrace> most;
    bool most_differs = false;
    for (const int frame : std::set{frames.front(), frames[frames.size() / 2], frames.back()}) {
        QueryTrace query = source.frame_again(frame);
        bool differs = false;
        if (compares() && !pairs_are_nodes(source.header()))
            differs = keep_pairs_of_one(query, sources_.back().frame_again(frame));
        if (!most || std::pair(differs, query.found.pairs.size()) >
                         std::pair(most_differs, most->found.pairs.size())) {
            most = std::move(query);
            most_differs = differs;
        }
    }
    if (most->found.pairs.empty()) return;
    const render::QueryBodies at_frame = bodies(most->frame);
    const std::vector<render::Segment> contact =
        render::contact_segments(at_frame, source.header(), *most);
    std::vector<AnyVolume> region;
    if (follows_contact() || is_of_distance(source.header().kind))
        region = near_contact(render::contact_region(at_frame, source.header(), *most, contact));
    seek(render::contact_subject(at_frame, source.header(), *most, contact), most->frame, region);
}

render::Support QueryView::support_over_frames(Reach reach) const {
    // All pictures of a run have the same direction of view, so there are only some twenty
    // directions.
    const auto known = std::make_shared<std::vector<std::pair<Vec3, double>>>();
    return [this, reach = std::move(reach), known](const Vec3& direction) {
        for (const auto& [of, most] : *known)
            if (of == direction) return most;
        double most = -std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < sources_.size(); ++i)
            for (const int frame : sources_[i].frames()) {
                const render::QueryBodies at_frame = bodies(frame, i);
                for (std::size_t side = 0; side < 2; ++side)
                    most = std::max(most, reach(at_frame[side], direction));
            }
        known->emplace_back(direction, most);
        return most;
    };
}

render::QueryBodies QueryView::bodies(int frame, std::size_t query_index) const {
    const QuerySource& source = sources_[query_index];
    render::QueryBodies bodies;
    for (std::size_t side = 0; side < 2; ++side) {
        BodyAtFrame at = source.body(side, frame);
        render::QueryBody& b = bodies[side];
        b.name = std::move(at.name);
        b.mesh = at.mesh.get();
        b.tree = at.tree.get();
        b.handle = handle_of(*at.mesh);
        b.pose = at.pose;
        b.first_node_id = ids_.nodes[side].first;
        b.first_triangle_id = ids_.triangles[side].first;
    }
    return bodies;
}

render::MeshHandle QueryView::handle_of(const Mesh& mesh) const {
    const auto [handle, added] = meshes_.try_emplace(&mesh);
    if (added) handle->second = renderer_.upload(mesh);
    return handle->second;
}

double QueryView::aspect() const {
    if (layout_) return render::aspect_of(layout_->sides[0].view);
    return render::aspect_of(options_.picture.layout().view);
}

double QueryView::least_radius() const {
    const render::QueryBodies first = bodies(sources_.front().frames().front());
    return std::min(render::root_diameter(*first[0].tree), render::root_diameter(*first[1].tree)) /
           50;
}

std::vector<AnyVolume> QueryView::near_contact(std::vector<AnyVolume> region) const {
    if (region.empty()) return region;
    const Ball contact = render::ball_about_centers(region);
    // A gap is often small, and empty about its line.
    const double radius = is_of_distance(sources_.front().header().kind) && contact.radius > 0
                              ? std::max(3 * contact.radius, least_radius() / 500)
                              : std::max(2 * contact.radius, least_radius());
    region.emplace_back(Ball{contact.center, radius});
    return region;
}

render::Camera QueryView::camera(const std::vector<AnyVolume>& region) const {
    if (!looks_closely(region)) return whole_;
    const std::vector<AnyVolume> wide = near_contact(region);
    render::Camera camera =
        camera_for(direction_of(camera_view_), render::support_of(wide), aspect());
    set_range_about(camera, support_, center(region));
    return camera;
}

bool QueryView::looks_closely(const std::vector<AnyVolume>& region) const {
    if (region.empty()) return false;
    // Twice as large, a wide contact would leave less of the view.
    if (follows_contact()) return render::extent_in_view(whole_, region) < wide_in_view;
    return options_.camera.leaves_distance_open(sources_.front().scene()) &&
           (options_.one_picture || (options_.sheet && !options_.animated) ||
            sources_.front().frames().size() == 1) &&
           render::extent_in_view(whole_, region) < small_in_view;
}

bool QueryView::is_whole(const render::Camera& camera) const {
    return camera.position == whole_.position && camera.view_height == whole_.view_height;
}

void QueryView::show_place_of_contact(render::SceneFigure& figure,
                                      const std::vector<AnyVolume>& region) const {
    if (region.empty()) return;
    const Ball contact = render::ball_about_centers(region);
    if (looks_closely(region)) {
        const render::Camera& camera = figure.pane.camera;
        const double radius = 0.5 / render::pixels_per_unit(camera, contact.center, 1);
        figure.detail =
            render::Detail{camera_for(camera_view_, held_, 1), contact.center, radius, true};
        render::set_depth_range(figure.detail->camera, support_);
        return;
    }
    if (render::extent_in_view(figure.pane.camera, region) > small_in_view) return;
    if (options_.one_picture) return;
    render::insert_before_notes(figure.panel,
                                {"the contact is small here: see it with --camera\u00a0contact"});
    const double radius = std::max(1.1 * contact.radius, least_radius());
    figure.detail = render::Detail{
        detail_camera(camera_view_, {contact.center, radius}, support_, 1), contact.center, radius};
}

scenes::CameraView QueryView::camera_view(const render::Camera& camera) const {
    return exact_camera_view(is_whole(camera) ? camera_view_ : direction_of(camera_view_), camera,
                             center_);
}

Vec3 QueryView::center(const std::vector<AnyVolume>& region) const {
    return looks_closely(region) ? render::center_of(render::support_of(region)) : center_;
}

std::string QueryView::title(const std::string& what) const {
    const TraceHeader &header = sources_.front().header(), &other = sources_.back().header();
    const std::string volumes = render::volume_title(header);
    return scene_title(header) + " · " +
           (volumes == render::volume_title(other) ? volumes + " · " : "") + what;
}

std::string QueryView::subtitle(std::optional<int> frame) const {
    const TraceHeader &header = sources_.front().header(), &other = sources_.back().header();
    const scenes::Scene& scene = sources_.front().scene();
    std::string text;
    const auto add = [&text](const std::string& part) {
        text += (text.empty() ? "" : ", ") + part;
    };
    // For two queries, only what they have in common; captions have the rest.
    const std::vector<TraceField> of_first = fields_of(header), of_other = fields_of(other);
    const auto common = [&](const char* name) {
        for (const TraceField& x : of_first)
            for (const TraceField& y : of_other)
                if (x.name == name && y.name == name && x.value != y.value) return false;
        return true;
    };
    if (frame && scene.frames > 1)
        add("frame " + std::to_string(*frame) + " of 0 to " + std::to_string(scene.frames - 1));
    if (!header.engine && !other.engine)
        for (const std::string& setting : settings_in_common(header, other, common)) add(setting);
    if (header.options.stop_level >= 0)
        add("to level " + std::to_string(header.options.stop_level));
    if (camera_view_.orthographic.value_or(false)) add("orthographic");
    if (camera_view_.clip) add("clipped");
    const std::string up = up_words(options_.camera, scene);
    if (options_.shown != Shown::nothing && !up.empty()) add(up);
    return text;
}

std::string QueryView::picture_name(const std::string& what, std::optional<int> frame,
                                    std::optional<std::size_t> test) const {
    const QuerySource& query = sources_.front();
    std::string queries = volume_file_part(query.header());
    if (compares()) {
        const std::string both = labels_[0].name + "-vs-" + labels_[1].name;
        queries =
            volume_file_part(sources_.back().header()) == queries ? queries + "_" + both : both;
    }
    NamedOptions named = named_;
    const std::vector<int>& frames = sources_.front().frames();
    if (!frame && frames != std::vector<int>{query.scene().default_frame})
        name_frames(named, frames);
    return app::picture_name(
        options_.scene.file_stem(query.header().scene), queries + "_" + what, named,
        (frame ? frame_part(*frame) : "") + (test ? format("_test-%07zu", *test) : ""));
}

void QueryView::tell_pick(PictureRun& pictures, const std::string& name,
                          const QueryFrames& frames) const {
    if (!options_.picture.pick) return;
    const PixelPosition at = *options_.picture.pick;
    const auto is_in = [&at](const render::PixelRect& r) {
        return at.x >= r.x && at.x < r.x + r.width && at.y >= r.y && at.y < r.y + r.height;
    };
    const std::size_t query = layout_ && is_in(layout_->sides[1].view) ? 1 : 0;
    pictures.say(options_.picture.picture_stem(name) + format(".png at %d,%d: ", at.x, at.y) +
                 id_text(ids_, sources_[query], frames, pictures.id_at(at.x, at.y)));
}

void QueryView::begin_sheet(PictureRun& pictures, const std::string& what,
                            std::optional<SheetRun> planned) const {
    if (!planned) return;
    const std::vector<int>& frames = sources_.front().frames();
    planned->one_frame = frames.size() == 1;
    planned->name = picture_name(what + "_sheet");
    planned->sheet.theme = options_.picture.theme();
    planned->sheet.subtitle =
        subtitle(planned->one_frame ? std::optional(frames[0]) : std::nullopt);
    pictures.begin_sheet(std::move(*planned));
}

}  // namespace scb::app
