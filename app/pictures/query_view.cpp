#include "app/pictures/query_view.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

#include "app/cli/build_text.h"
#include "app/query/scene_title.h"
#include "core/base/text_format.h"
#include "render/figures/volume_titles.h"
#include "scb/level_cover.h"

namespace scb::app {
namespace {

double root_diameter(const AnyHierarchy& hierarchy) {
    return std::visit([](const auto& h) { return diameter(h.volumes[0]); }, hierarchy);
}

/// The nodes whose volumes a camera has to hold: some that cover the mesh closely; or all leaves;
/// or, since a volume may stick out of its parent's, all of the upper levels, below which they
/// stick out little.
std::vector<std::uint32_t> held_nodes(const AnyHierarchy& hierarchy, Shown shown) {
    constexpr int levels = 6;
    const Topology& topology = topology_of(hierarchy);
    if (shown == Shown::meshes) return level_cover(topology, levels);
    if (shown == Shown::leaves) return level_cover(topology, leaf_level);
    std::vector<std::uint32_t> nodes;
    const std::vector<std::uint16_t> depths = node_depths(topology);
    for (std::uint32_t node = 0; node < depths.size(); ++node)
        if (depths[node] <= levels) nodes.push_back(node);
    return nodes;
}

}  // namespace

std::string stopped_remark(const TraceFrame& frame) {
    return "stopped at " + render::count_text(frame.found.pairs.size()) +
           (frame.found.pairs.size() == 1 ? " pair" : " pairs");
}

QueryView::QueryView(const QueryViewOptions& options, const QuerySources& sources,
                     render::Renderer& renderer, std::optional<render::ComparisonLayout> layout)
    : options_(options), sources_(sources), named_(options.named), layout_(layout) {
    if (compares()) labels_ = query_labels(sources[0].header(), sources[1].header());
    name_query(named_, sources.front(), sources.back());
    if (options.shown != Shown::nothing) name_view(named_, options.picture, options.camera);
    name_picture(named_, options.picture);
    if (options.shown == Shown::nothing) return;
    const SceneQuery& query = sources.front().query();
    for (const scenes::NamedMesh& mesh : query.scene.meshes)
        meshes_.push_back(renderer.upload(mesh.mesh));
    ids_ = id_ranges(query);
    camera_view_ = camera_view_for(options.camera, query.scene);
    std::array<std::vector<std::uint32_t>, 2> nodes;
    for (std::size_t side = 0; side < 2; ++side)
        nodes[side] = held_nodes(query.hierarchy(side == 0 ? query.a : query.b), options.shown);
    support_ = support_over_frames(
        [nodes](const render::QueryBody& body, std::size_t side, const Vec3& direction) {
            double most = -std::numeric_limits<double>::infinity();
            for (const std::uint32_t node : nodes[side])
                most = std::max(most, render::reach(render::volume_of(body, node), direction));
            return most;
        });
    render::Support held = support_;
    if (options.held_part < 1)
        held = render::support_between(
            support_over_frames([](const render::QueryBody& body, std::size_t,
                                   const Vec3& direction) { return mesh_reach(body, direction); }),
            support_, options.held_part);
    center_ = render::center_of(held);
    whole_ = camera_for(camera_view_, held, aspect());
    render::set_depth_range(whole_, support_);
}

render::Support QueryView::support_over_frames(Reach reach) const {
    // The pictures of a run have one direction of view, so these are some twenty directions.
    const auto known = std::make_shared<std::vector<std::pair<Vec3, double>>>();
    return [this, reach = std::move(reach), known](const Vec3& direction) {
        for (const auto& [of, most] : *known)
            if (of == direction) return most;
        double most = -std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < sources_.size(); ++i)
            for (const int frame : sources_[i].frames()) {
                const render::QueryBodies at_frame = bodies(frame, i);
                for (std::size_t side = 0; side < 2; ++side)
                    most = std::max(most, reach(at_frame[side], side, direction));
            }
        known->emplace_back(direction, most);
        return most;
    };
}

render::QueryBodies QueryView::bodies(int frame, std::size_t query_index) const {
    const SceneQuery& query = sources_[query_index].query();
    render::QueryBodies bodies;
    for (std::size_t side = 0; side < 2; ++side) {
        const std::size_t index = side == 0 ? query.a : query.b;
        const scenes::Body& body = query.scene.bodies[index];
        render::QueryBody& b = bodies[side];
        b.name = body.name;
        b.mesh = &query.mesh(index);
        b.hierarchy = &query.hierarchy(index);
        b.handle = meshes_[body.mesh];
        b.pose = scenes::pose_at(body.motion, frame);
        b.first_node_id = ids_.nodes[side].first;
        b.first_triangle_id = ids_.triangles[side].first;
    }
    return bodies;
}

double QueryView::aspect() const {
    if (layout_) return render::aspect_of(layout_->sides[0].view);
    return render::aspect_of(options_.picture.layout().view);
}

double QueryView::least_radius() const {
    const SceneQuery& query = sources_.front().query();
    return std::min(root_diameter(query.hierarchy(query.a)),
                    root_diameter(query.hierarchy(query.b))) /
           50;
}

render::Camera QueryView::camera(const std::vector<render::AnyVolume>& region) const {
    if (!follows_contact() || region.empty()) return whole_;
    // Not so close that a single small triangle fills the view.
    std::vector<render::AnyVolume> wide = region;
    const render::Support of_region = render::support_of(region);
    const Vec3 middle = render::center_of(of_region);
    scenes::CameraView wish = camera_view_;
    wish.target.reset();
    wish.distance.reset();
    wish.view_height.reset();
    wide.emplace_back(Ball{middle, least_radius()});
    render::Camera camera = camera_for(wish, render::support_of(wide), aspect());
    render::set_depth_range(camera, support_);
    return camera;
}

void QueryView::show_small_contact(render::SceneFigure& figure,
                                   const std::vector<render::AnyVolume>& region) const {
    if (follows_contact() || region.empty()) return;
    constexpr double small = 1.0 / 8;
    if (render::extent_in_view(figure.pane.camera, region) > small) return;
    render::insert_before_notes(figure.panel,
                                {"the contact is small here: see it with --camera\u00a0contact"});
    const Ball contact = render::ball_about_centers(region);
    const double radius = std::max(1.1 * contact.radius, least_radius());
    figure.detail = render::Detail{
        detail_camera(camera_view_, {contact.center, radius}, support_, 1), contact.center, radius};
}

scenes::CameraView QueryView::camera_view(const render::Camera& camera) const {
    return exact_camera_view(camera_view_, camera, center_);
}

Vec3 QueryView::center(const std::vector<render::AnyVolume>& region) const {
    return !follows_contact() || region.empty() ? center_
                                                : render::center_of(render::support_of(region));
}

std::string QueryView::title(const std::string& what) const {
    const SceneQuery& query = sources_.front().query();
    const bool one_kind = sources_.back().query().kind == query.kind;
    return scene_title(query.scene.name, query.scene.bodies[query.a].name,
                       query.scene.bodies[query.b].name) +
           " · " + (one_kind ? std::string(render::volume_title(query.kind)) + " · " : "") + what;
}

std::string QueryView::subtitle(std::optional<int> frame) const {
    const TraceHeader &header = sources_.front().header(), &other = sources_.back().header();
    const scenes::Scene& scene = sources_.front().query().scene;
    std::string text;
    const auto add = [&text](const std::string& part) {
        text += (text.empty() ? "" : ", ") + part;
    };
    // Of two queries, what they have in common; captions say the rest.
    const std::vector<TraceField> of_first = fields_of(header), of_other = fields_of(other);
    const auto common = [&](const char* name) {
        for (const TraceField& x : of_first)
            for (const TraceField& y : of_other)
                if (x.name == name && y.name == name && x.value != y.value) return false;
        return true;
    };
    if (frame && scene.frames > 1)
        add("frame " + std::to_string(*frame) + " of 0 to " + std::to_string(scene.frames - 1));
    const TraceHeader& of_scb = header.volume == VolumeKind::scb ? header : other;
    if (of_scb.volume == VolumeKind::scb) {
        const OverlapOptions& overlap = of_scb.options.overlap;
        // Of two kinds of volumes the captions say it, since it is that of one of them.
        if (common("test") && other.volume == header.volume)
            add("test " + std::string(overlap_test_name(overlap.test)));
        if (common("threshold") && has_threshold(overlap.test) &&
            overlap.threshold != OverlapOptions{}.threshold)
            add(format("threshold %g", overlap.threshold));
    }
    if (common("descent") && header.options.descent != CollideOptions{}.descent)
        add("descent by " + std::string(descent_rule_name(header.options.descent)));
    BuildOptions build;
    if (common("growth")) build.fit.growth = header.growth;
    if (common("margin")) build.fit.margin = header.margin;
    if (common("split")) build.split = header.split;
    for (const std::string& part : build_parts(build)) add(part);
    if (header.options.stop_level >= 0)
        add("to level " + std::to_string(header.options.stop_level));
    if (camera_view_.orthographic.value_or(false)) add("orthographic");
    const std::string up = up_words(options_.camera, scene);
    if (options_.shown != Shown::nothing && !up.empty()) add(up);
    return text;
}

std::string QueryView::picture_name(const std::string& what, std::optional<int> frame,
                                    std::optional<std::size_t> test) const {
    const SceneQuery& query = sources_.front().query();
    std::string queries(volume_kind_name(query.kind));
    if (compares()) {
        const std::string both = labels_[0].name + "-vs-" + labels_[1].name;
        queries = sources_.back().query().kind == query.kind ? queries + "_" + both : both;
    }
    NamedOptions named = named_;
    const std::vector<int>& frames = sources_.front().frames();
    if (!frame && frames != std::vector<int>{query.scene.default_frame}) name_frames(named, frames);
    return app::picture_name(
        query.scene.name, queries + "_" + what, named,
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
    pictures.say(name + format(".png at %d,%d: ", at.x, at.y) +
                 id_text(ids_, sources_[query].query(), frames, pictures.id_at(at.x, at.y)));
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
