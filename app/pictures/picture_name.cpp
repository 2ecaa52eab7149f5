#include "app/pictures/picture_name.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/base/text_format.h"
#include "scenes/scene/pose_rows.h"

namespace scb::app {
namespace {

// File names may have 255 bytes, including endings.
constexpr std::size_t most_of_options = 100, most_of_name = 220;

std::string shortened(const std::string& text, std::size_t most) {
    if (text.size() <= most) return text;
    const std::string hash = "-" + short_hash(text);
    return text.substr(0, most - hash.size()) + hash;
}

/// "0-to-490-by-10".
std::string list_part(const std::vector<int>& numbers) {
    const int step = numbers.size() < 3 ? 0 : numbers[1] - numbers[0];
    const bool even =
        step > 0 && std::adjacent_find(numbers.begin(), numbers.end(), [step](int a, int b) {
                        return b - a != step;
                    }) == numbers.end();
    if (even)
        return format("%d-to-%d", numbers.front(), numbers.back()) +
               (step == 1 ? "" : format("-by-%d", step));
    std::string list;
    for (const int number : numbers) list += (list.empty() ? "" : "-") + std::to_string(number);
    return list;
}

/// "orbit-40-15". For a file, its name and a hash of the camera, since every index.json has the
/// same name.
std::string camera_part(const std::string& camera) {
    if (camera == "fit" || camera == "contact" || camera.starts_with("orbit:")) return camera;
    return std::filesystem::path(camera).stem().string() + "-" +
           short_hash(scenes::camera_json(scenes::parse_camera(camera)).dump());
}

/// "0,0,1,0.3".
std::string plane_part(const FacePlane& plane) {
    std::string numbers;
    for (int i = 0; i < 3; ++i) numbers += exact_number(plane.normal[i]) + ",";
    return numbers + exact_number(plane.offset);
}

}  // namespace

void NamedOptions::add(const std::string& option, const std::string& value) {
    text_ += "_" + option;
    if (!value.empty()) text_ += "-" + scenes::file_name_of(shortened(value, most_of_options));
}

NamedOptions NamedOptions::operator+(const NamedOptions& others) const {
    NamedOptions all = *this;
    all.text_ += others.text_;
    return all;
}

std::string NamedOptions::text() const { return shortened(text_, most_of_options); }

void name_build(NamedOptions& named, const BuildOptions& options) {
    const BuildOptions usual;
    named.add_if(options.split != usual.split, "split",
                 std::string(split_method_name(options.split)));
    named.add_if(options.fit.growth != usual.fit.growth, "growth",
                 std::string(ball_growth_name(options.fit.growth)));
    named.add_if(options.fit.margin != usual.fit.margin, "margin",
                 exact_number(options.fit.margin));
}

void name_pose(NamedOptions& named, const std::vector<double>& pose) {
    const std::vector<double> identity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    if (pose.empty() || pose == identity) return;
    std::string numbers;
    for (const double number : pose) numbers += exact_number(number + 0.0) + ",";  // -0 is 0
    named.add("pose", short_hash(numbers));
}

std::string volume_file_part(const TraceHeader& header) {
    return header.engine ? scenes::file_name_of(header.engine->name)
                         : std::string(volume_kind_name(header.volume));
}

void name_query(NamedOptions& named, const QuerySource& query, const QuerySource& other) {
    const scenes::Scene& scene = query.scene();
    const std::size_t a = query.body_index(0), b = query.body_index(1);
    if (scene.bodies.size() > 2 || (scene.bodies.size() == 2 && a >= b))
        named.add("bodies", scene.bodies[a].name + "-" + scene.bodies[b].name);
    if (query.is_recording() || other.is_recording()) return;
    if (query.header().source.size() == 2) {
        const scenes::PoseRows rows = scenes::rows_of(query.query().b_to_a(0));
        name_pose(named, {rows.begin(), rows.end()});
    }
    TraceHeader usual = query.header();
    const BuildOptions build;
    usual.split = build.split;
    usual.growth = build.fit.growth;
    usual.margin = build.fit.margin;
    // The test determines whether there is a threshold.
    const OverlapTest test = usual.options.overlap.test;
    usual.options = {};
    usual.distance = {};
    usual.tolerance = -1;
    usual.options.overlap.test = test;
    usual.options.max_pairs = static_cast<std::size_t>(QueryLimits{}.max_pairs);
    const std::vector<TraceField> as_usual = fields_of(usual), here = fields_of(query.header()),
                                  there = fields_of(other.header());
    const auto has = [](const std::vector<TraceField>& fields, const TraceField& field) {
        return std::any_of(fields.begin(), fields.end(), [&](const TraceField& f) {
            return f.name == field.name && f.value == field.value;
        });
    };
    for (const TraceField& field : here) {
        const bool is_usual =
            field.name == "test" ? test == OverlapOptions{}.test : has(as_usual, field);
        if (is_usual || !has(there, field)) continue;
        std::string option = field.name;
        std::replace(option.begin(), option.end(), ' ', '-');
        named.add(option, field.value);
    }
}

void name_picture(NamedOptions& named, const PictureOptions& options) {
    const PictureOptions usual;
    const bool usual_size = options.width() == usual.width() && options.height() == usual.height();
    named.add_if(!usual_size, "size", format("%dx%d", options.width(), options.height()));
    named.add_if(options.no_panel, "no-panel");
    named.add_if(options.background != usual.background, "background", options.background);
}

void name_view(NamedOptions& named, const PictureOptions& options, const CameraOptions& camera) {
    if (!camera.camera.empty()) named.add("camera", camera_part(camera.camera));
    named.add_if(!camera.up.empty(), "up", camera.up);
    named.add_if(camera.orthographic, "ortho");
    if (const std::optional<FacePlane> clip = camera.clip_plane()) {
        const std::string plane = plane_part(*clip);
        // NamedOptions drops a minus at the beginning of a value.
        named.add(plane.starts_with('-') ? "clip-" : "clip", plane);
    }
    named.add_if(options.samples != PictureOptions{}.samples, "samples",
                 std::to_string(options.samples));
}

void name_frames(NamedOptions& named, const std::vector<int>& frames) {
    named.add("frames", list_part(frames));
}

std::string picture_name(const std::string& scene, const std::string& what,
                         const NamedOptions& options, const std::string& which) {
    const std::string name = scene + "_" + what + options.text();
    const std::string end = which.empty() ? "" : "_" + which;
    return shortened(shortened(name, most_of_name) + end, most_of_name + 8);
}

std::string frame_part(int frame) { return format("frame-%04d", frame); }

}  // namespace scb::app
