#include "scenes/scene/camera_view.h"

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/base/text_format.h"
#include "core/platform/input_files.h"
#include "scb/error.h"

namespace scb::scenes {
namespace {

constexpr std::string_view option_help =
    "give fit, orbit:AZIMUTH,ELEVATION[,DISTANCE[,X,Y,Z]] or the path of a JSON file.";

CameraView parse_orbit(std::string_view text) {
    const std::string_view numbers = text.substr(text.find(':') + 1);
    const auto fail = [text](const std::string& reason) {
        throw InputError("--camera " + std::string(text) + ": " + reason + "; " +
                         std::string(option_help));
    };
    std::vector<double> values;
    const char* at = numbers.data();
    const char* const end = numbers.data() + numbers.size();
    while (true) {
        double value = 0;
        const auto parsed = std::from_chars(at, end, value);
        if (parsed.ec != std::errc{} || !std::isfinite(value))
            fail("number " + std::to_string(values.size() + 1) + " cannot be read");
        values.push_back(value);
        at = parsed.ptr;
        if (at == end) break;
        if (*at != ',') fail("a comma is expected after number " + std::to_string(values.size()));
        ++at;
    }
    if (values.size() != 2 && values.size() != 3 && values.size() != 6)
        fail("two, three or six numbers are expected");
    CameraView camera;
    camera.azimuth = values[0];
    camera.elevation = values[1];
    if (!(std::abs(camera.azimuth) <= 1e6)) fail("the azimuth must be -1e6 to 1e6 degrees");
    if (!(std::abs(camera.elevation) <= 90)) fail("the elevation must be -90 to 90 degrees");
    if (values.size() > 2) {
        if (!(values[2] > 0 && values[2] <= max_coordinate))
            fail("the distance must be above 0 and at most " + exact_number(max_coordinate));
        camera.distance = values[2];
    }
    if (values.size() == 6) {
        camera.target = Vec3(values[3], values[4], values[5]);
        if (!(camera.target->cwiseAbs().maxCoeff() <= max_coordinate))
            fail("the target must be at most " + exact_number(max_coordinate) + " from 0");
    }
    return camera;
}

nlohmann::ordered_json array_of(const Vec3& v) { return {v[0], v[1], v[2]}; }

}  // namespace

CameraView read_camera(const JsonPlace& place) {
    check_fields(place, {"azimuth", "elevation", "distance", "target", "up", "field_of_view",
                         "orthographic", "view_height", "inset", "clip"});
    CameraView camera;
    if (has(place, "azimuth")) camera.azimuth = read_number(field(place, "azimuth"), -1e6, 1e6);
    if (has(place, "elevation")) camera.elevation = read_number(field(place, "elevation"), -90, 90);
    if (has(place, "distance")) camera.distance = read_positive(field(place, "distance"));
    if (has(place, "target")) camera.target = read_vec3(field(place, "target"));
    if (has(place, "up")) camera.up = read_direction(field(place, "up"));
    if (has(place, "field_of_view"))
        camera.field_of_view = read_number(field(place, "field_of_view"), 1, 170);
    if (has(place, "orthographic")) camera.orthographic = read_bool(field(place, "orthographic"));
    if (has(place, "view_height")) camera.view_height = read_positive(field(place, "view_height"));
    if (has(place, "inset")) {
        const JsonPlace inset = field(place, "inset");
        check_fields(inset, {"center", "radius"});
        camera.inset =
            Inset{read_vec3(field(inset, "center")), read_positive(field(inset, "radius"))};
    }
    if (has(place, "clip")) {
        const JsonPlace clip = field(place, "clip");
        check_fields(clip, {"normal", "offset"});
        camera.clip =
            FacePlane{read_direction(field(clip, "normal")), read_number(field(clip, "offset"))};
    }
    return camera;
}

CameraView parse_camera_json(std::string_view json_text, const std::string& file) {
    const nlohmann::json document = parse_json(json_text, file);
    const JsonPlace root{&document, file, ""};
    if (document.is_object() && has(root, "camera")) return read_camera(field(root, "camera"));
    return read_camera(root);
}

CameraView parse_camera(std::string_view text) {
    if (text == "fit") return {};
    if (text.substr(0, 6) == "orbit:") return parse_orbit(text);
    const std::string file(text);
    if (text.empty() || (text.find('.') == text.npos && text.find('/') == text.npos))
        throw InputError("--camera " + file + ": this is not a camera; " +
                         std::string(option_help));
    note_input(file);
    return parse_camera_json(read_text_file(file), file);
}

nlohmann::ordered_json camera_json(const CameraView& camera) {
    nlohmann::ordered_json json = {{"azimuth", camera.azimuth}, {"elevation", camera.elevation}};
    if (camera.distance) json["distance"] = *camera.distance;
    if (camera.target) json["target"] = array_of(*camera.target);
    if (camera.up) json["up"] = array_of(*camera.up);
    json["field_of_view"] = camera.field_of_view;
    if (camera.orthographic) json["orthographic"] = *camera.orthographic;
    if (camera.view_height) json["view_height"] = *camera.view_height;
    if (camera.inset)
        json["inset"] = {{"center", array_of(camera.inset->center)},
                         {"radius", camera.inset->radius}};
    if (camera.clip)
        json["clip"] = {{"normal", array_of(camera.clip->normal)}, {"offset", camera.clip->offset}};
    return json;
}

}  // namespace scb::scenes
