#include "scenes/meshes/collada_plain.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <iterator>
#include <map>
#include <vector>

#include "core/platform/tokens.h"
#include "scb/error.h"
#include "scenes/meshes/collada_check.h"
#include "scenes/meshes/xml_reader.h"

namespace scb::scenes {
namespace {

/// The geometry that a skin or morph controller deforms, by the id of the controller.
struct Controller {
    std::string_view source;
    bool is_skin = false;
};
using Controllers = std::map<std::string_view, Controller>;

Controllers controllers_of(std::string_view bytes, const std::string& name) {
    Controllers controllers;
    std::string_view id;
    XmlReader reader(bytes, name);
    while (const std::optional<XmlEvent> event = reader.next()) {
        if (event->kind != XmlEvent::start) continue;
        if (event->name == "controller") id = xml_attribute(event->attributes, "id").value_or("");
        if (event->name != "skin" && event->name != "morph") continue;
        const std::string_view source = xml_attribute(event->attributes, "source").value_or("");
        controllers.try_emplace(id, Controller{source, event->name == "skin"});
    }
    return controllers;
}

struct NumberArray {
    std::uint64_t count = 0;
    bool has_numbers = false;  ///< numbers, not names
};

struct Accessor {
    std::string_view array;
    std::uint64_t offset = 0, count = 0, stride = 1, parameters = 0;
};

class ColladaReducer {
  public:
    ColladaReducer(std::string_view bytes, const std::string& name)
        : controllers_(controllers_of(bytes, name)), reader_(bytes, name), name_(name) {
        plain_.bytes.reserve(bytes.size());
    }

    PlainFile reduced() {
        while (const std::optional<XmlEvent> event = reader_.next()) {
            if (event->kind == XmlEvent::start)
                start(*event);
            else if (event->kind == XmlEvent::end)
                end(*event);
            else if (skipped_ == 0)
                append_text(*event);
        }
        for (const Accessor& accessor : accessors_) check(accessor);
        if (has_skins_) plain_.left_out.emplace_back("skins");
        if (has_morphs_) plain_.left_out.emplace_back("morph targets");
        return std::move(plain_);
    }

  private:
    /// `depth`: the number of elements around it.
    static bool is_kept(std::string_view element, std::size_t depth) {
        constexpr std::string_view libraries[] = {"asset", "library_geometries", "library_nodes",
                                                  "library_visual_scenes", "scene"};
        constexpr std::string_view dropped[] = {"extra", "bind_material", "instance_light",
                                                "instance_camera", "instance_physics_scene"};
        const auto is_in = [&](const auto& names) {
            return std::find(std::begin(names), std::end(names), element) != std::end(names);
        };
        return depth == 1 ? is_in(libraries) : !is_in(dropped);
    }

    void start(const XmlEvent& event) {
        const std::size_t depth = depth_++;
        const bool is_controller = event.name == "instance_controller";
        if (skipped_ == 0 && is_controller) append_geometry(event);
        if (skipped_ > 0 || is_controller || !is_kept(event.name, depth)) {
            ++skipped_;
            return;
        }
        note(event);
        plain_.bytes.append("<").append(event.name).append(event.attributes).append(">");
    }
    void end(const XmlEvent& event) {
        --depth_;
        if (skipped_ > 0)
            --skipped_;
        else
            plain_.bytes.append("</").append(event.name).append(">");
    }

    void append_text(const XmlEvent& event) {
        if (!event.is_cdata) {
            plain_.bytes.append(event.content);
            return;
        }
        for (const char c : event.content)
            if (c == '<')
                plain_.bytes += "&lt;";
            else if (c == '&')
                plain_.bytes += "&amp;";
            else
                plain_.bytes += c;
    }

    /// Appends the geometry that a controller deforms, in place of the controller.
    void append_geometry(const XmlEvent& event) {
        std::string_view url = xml_attribute(event.attributes, "url").value_or("");
        // At most as many steps as there are controllers, since they may name each other in a ring.
        for (std::size_t i = 0; i <= controllers_.size() && url.starts_with('#'); ++i) {
            const auto found = controllers_.find(url.substr(1));
            if (found == controllers_.end()) break;
            (found->second.is_skin ? has_skins_ : has_morphs_) = true;
            url = found->second.source;
        }
        if (url.find_first_of("\"<") != url.npos)
            throw InputError(name_ + ": a controller deforms \"" + excerpt(url) +
                             "\", which is not the id of a geometry; export the file again.");
        plain_.bytes.append("<instance_geometry url=\"").append(url).append("\"/>");
    }

    /// Stores the data for the check of accessors.
    void note(const XmlEvent& event) {
        if (event.name.ends_with("_array")) {
            const std::string_view id = identifier(event, "id");
            const NumberArray array{whole(event, "count", 0, id), event.name == "float_array"};
            if (!arrays_.try_emplace(id, array).second)
                throw InputError(name_ + ": two arrays have the id \"" + excerpt(id) +
                                 "\"; rename one.");
        } else if (event.name == "accessor") {
            const std::string_view source = identifier(event, "source");
            accessors_.push_back(
                {source.substr(source.starts_with('#') ? 1 : 0), whole(event, "offset", 0, source),
                 whole(event, "count", 0, source), whole(event, "stride", 1, source)});
        } else if (event.name == "param" && !accessors_.empty()) {
            ++accessors_.back().parameters;
        }
    }

    /// An attribute that names an array, without escaped letters.
    std::string_view identifier(const XmlEvent& event, const char* attribute) const {
        const std::string_view text = xml_attribute(event.attributes, attribute).value_or("");
        for (const char c : text)
            if (static_cast<unsigned char>(c) < 0x20 || c == '&')
                throw InputError(name_ + ": the " + attribute + " \"" + excerpt(text) +
                                 "\" of an array has a line end or an entity; rename the array.");
        return text;
    }

    std::uint64_t whole(const XmlEvent& event, const char* attribute, std::uint32_t otherwise,
                        std::string_view array) const {
        const std::optional<std::string_view> text = xml_attribute(event.attributes, attribute);
        if (!text) return otherwise;
        std::uint32_t number = 0;
        const auto parsed = std::from_chars(text->data(), text->data() + text->size(), number);
        if (parsed.ec != std::errc{} || parsed.ptr != text->data() + text->size())
            throw InputError(name_ + ": array \"" + excerpt(array) + "\": the " + attribute +
                             " is \"" + excerpt(*text) +
                             "\", which is not a whole number from 0; repair it.");
        return number;
    }

    void check(const Accessor& accessor) const {
        const auto array = arrays_.find(accessor.array);
        const std::string place = name_ + ": array \"" + excerpt(accessor.array) + "\"";
        if (array == arrays_.end() || !array->second.has_numbers)
            throw InputError(place +
                             ", which an accessor reads, is not a float_array of the file; export "
                             "the file again.");
        if (accessor.count == 0) return;
        const std::uint64_t needed = accessor.offset + (accessor.count - 1) * accessor.stride +
                                     std::max<std::uint64_t>(accessor.parameters, 1);
        if (needed > array->second.count)
            throw InputError(place + " has " + std::to_string(array->second.count) +
                             " numbers, but its accessor needs " + std::to_string(needed) +
                             "; repair the counts.");
    }

    const Controllers controllers_;
    XmlReader reader_;
    const std::string& name_;
    PlainFile plain_;
    std::size_t depth_ = 0, skipped_ = 0;
    std::map<std::string_view, NumberArray> arrays_;
    std::vector<Accessor> accessors_;
    bool has_skins_ = false, has_morphs_ = false;
};

}  // namespace

std::optional<PlainFile> plain_collada(std::string_view bytes, const std::string& name) {
    check_collada(bytes, name);
    // assimp's reader stops at a zero byte.
    return ColladaReducer(bytes.substr(0, bytes.find('\0')), name).reduced();
}

}  // namespace scb::scenes
