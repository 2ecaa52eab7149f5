#include "scenes/meshes/gltf_plain.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <map>
#include <nlohmann/json.hpp>

#include "core/platform/json_reader.h"
#include "scb/error.h"
#include "scenes/meshes/gltf_check.h"
#include "scenes/meshes/gltf_document.h"

namespace scb::scenes {
namespace {

using nlohmann::json;

constexpr const char *draco = "KHR_draco_mesh_compression", *instancing = "EXT_mesh_gpu_instancing";

void keep_only(json& object, std::initializer_list<const char*> fields) {
    json kept = json::object();
    for (const char* field : fields)
        if (object.contains(field)) kept[field] = std::move(object.at(field));
    object = std::move(kept);
}

std::string base64(std::string_view bytes) {
    constexpr std::string_view letters =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve(bytes.size() / 3 * 4 + 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits =
                bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k > bytes.size() ? '=' : letters[bits >> (18 - 6 * k) & 63];
    }
    return text;
}

/// Numbers of accessors, written out.
class WrittenAccessors {
  public:
    explicit WrittenAccessors(GltfDocument& document) : document_(document) {}

    /// The written accessor with the numbers of another one, the same for all uses.
    std::size_t written(std::size_t accessor, bool positions, const std::string& place) {
        const auto [found, is_new] = numbers_.try_emplace({accessor, positions}, std::size_t{0});
        if (is_new) found->second = write(accessor, positions, place);
        return found->second;
    }
    /// The same accessor with floats, the same for all uses.
    std::size_t as_floats(std::size_t accessor) {
        const auto [found, is_new] = floats_.try_emplace(accessor, std::size_t{0});
        if (!is_new) return found->second;
        json& accessors = document_.root.at("accessors");
        json copy = accessors.at(accessor);
        copy["componentType"] = static_cast<std::size_t>(gltf_float);
        accessors.push_back(std::move(copy));
        return found->second = accessors.size() - 1;
    }

    /// Adds the buffers; until then the document has the file's buffers.
    void add_buffers() {
        if (buffers_.empty()) return;
        json& buffers = document_.root["buffers"];
        // The first buffer of a .glb is its binary chunk.
        if (buffers.empty()) buffers.push_back({{"byteLength", std::size_t{0}}});
        for (json& buffer : buffers_) buffers.push_back(std::move(buffer));
    }

  private:
    std::size_t of_file() const {
        const auto buffers = document_.root.find("buffers");
        return buffers == document_.root.end() ? 1 : std::max<std::size_t>(buffers->size(), 1);
    }

    std::size_t write(std::size_t accessor, bool positions, const std::string& place) {
        json& accessors = document_.root.at("accessors");
        const std::vector<double> numbers =
            gltf_numbers(document_, accessors.at(accessor), positions ? "VEC3" : "SCALAR", place);
        std::string bytes(4 * numbers.size(), '\0');
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            const float value = static_cast<float>(numbers[i]);
            const auto index = static_cast<std::uint32_t>(positions ? 0 : numbers[i]);
            std::uint32_t bits = 0;
            std::memcpy(&bits, positions ? static_cast<const void*>(&value) : &index, sizeof bits);
            for (std::size_t b = 0; b < 4; ++b)
                bytes[4 * i + b] = static_cast<char>(bits >> (8 * b) & 255);
        }
        json& views = document_.root["bufferViews"];
        const std::size_t buffer = of_file() + buffers_.size();
        views.push_back(
            {{"buffer", buffer}, {"byteOffset", std::size_t{0}}, {"byteLength", bytes.size()}});
        accessors.push_back(
            {{"bufferView", views.size() - 1},
             {"componentType", static_cast<std::size_t>(positions ? gltf_float : gltf_uint32)},
             {"count", numbers.size() / (positions ? 3 : 1)},
             {"type", positions ? "VEC3" : "SCALAR"}});
        buffers_.push_back({{"byteLength", bytes.size()},
                            {"uri", "data:application/octet-stream;base64," + base64(bytes)}});
        return accessors.size() - 1;
    }

    GltfDocument& document_;
    std::map<std::pair<std::size_t, bool>, std::size_t> numbers_;
    std::map<std::size_t, std::size_t> floats_;
    std::vector<json> buffers_;
};

void write_out(WrittenAccessors& written, const GltfDocument& document, json& primitive,
               const std::string& place) {
    const bool in_draco = gltf_is_in_draco(primitive);
    keep_only(primitive, {"attributes", "indices", "mode", "extensions"});
    if (primitive.contains("extensions")) keep_only(primitive.at("extensions"), {draco});
    if (!primitive.contains("attributes")) return;
    keep_only(primitive.at("attributes"), {"POSITION"});
    if (!primitive.at("attributes").contains("POSITION")) return;
    const json& accessors = document.root.at("accessors");
    const std::size_t position = gltf_natural(primitive.at("attributes"), "POSITION");
    const bool is_float = gltf_natural(accessors.at(position), "componentType") == gltf_float;
    if (in_draco) {
        json& packed = primitive.at("extensions").at(draco);
        keep_only(packed, {"bufferView", "attributes"});
        keep_only(packed.at("attributes"), {"POSITION"});
        if (!is_float) primitive.at("attributes")["POSITION"] = written.as_floats(position);
        return;
    }
    if (!is_float || accessors.at(position).contains("sparse"))
        primitive.at("attributes")["POSITION"] = written.written(position, true, place);
    if (!primitive.contains("indices")) return;
    const std::size_t indices = gltf_natural(primitive, "indices");
    if (accessors.at(indices).contains("sparse"))
        primitive["indices"] = written.written(indices, false, place);
}

/// Adds the instances of a node as nodes below it.
void place_instances(GltfDocument& document, std::size_t node, const std::string& place) {
    json& nodes = document.root.at("nodes");
    const json attributes = nodes.at(node).at("extensions").at(instancing).at("attributes");
    struct Part {
        const char *attribute, *field, *type;
        std::size_t components;
        std::vector<double> numbers{};
    };
    Part parts[] = {{"TRANSLATION", "translation", "VEC3", 3},
                    {"ROTATION", "rotation", "VEC4", 4},
                    {"SCALE", "scale", "VEC3", 3}};
    std::size_t count = 0;
    bool some = false;
    for (Part& part : parts) {
        if (!attributes.contains(part.attribute)) continue;
        part.numbers = gltf_numbers(
            document, document.root.at("accessors").at(gltf_natural(attributes, part.attribute)),
            part.type, place);
        const std::size_t instances = part.numbers.size() / part.components;
        if (some && instances != count)
            throw InputError(place + ": the attributes of its instances have " +
                             std::to_string(count) + " and " + std::to_string(instances) +
                             " elements; export it again.");
        count = instances;
        some = true;
    }
    if (!some)
        throw InputError(place + ": its instances (" + instancing +
                         ") have neither TRANSLATION, ROTATION nor SCALE; export it again.");
    const json mesh = nodes.at(node).at("mesh");
    json children =
        nodes.at(node).contains("children") ? nodes.at(node).at("children") : json::array();
    for (std::size_t i = 0; i < count; ++i) {
        json instance = {{"mesh", mesh}};
        for (const Part& part : parts)
            if (!part.numbers.empty()) {
                const auto first =
                    part.numbers.begin() + static_cast<std::ptrdiff_t>(i * part.components);
                instance[part.field] = std::vector<double>(
                    first, first + static_cast<std::ptrdiff_t>(part.components));
                // JSON has no NaN or infinity.
                for (const json& number : instance.at(part.field))
                    if (!std::isfinite(number.get<double>()))
                        throw InputError(place + ": instance " + std::to_string(i) + " has a " +
                                         part.field + " that is not finite; export it again.");
            }
        children.push_back(nodes.size());
        nodes.push_back(std::move(instance));
    }
    nodes.at(node).erase("mesh");
    nodes.at(node)["children"] = std::move(children);
}

void plain_nodes(GltfDocument& document) {
    json& root = document.root;
    if (!root.contains("nodes") || root.at("nodes").empty()) {
        if (root.contains("scenes") && !root.at("scenes").empty()) return;
        json nodes = json::array();
        for (std::size_t m = 0; m < root.at("meshes").size(); ++m) nodes.push_back({{"mesh", m}});
        root["nodes"] = std::move(nodes);
    }
    const std::size_t count = root.at("nodes").size();
    for (std::size_t n = 0; n < count; ++n) {
        const std::string place = document.name + ": node " + std::to_string(n);
        try {
            const json& node = root.at("nodes").at(n);
            if (node.contains("mesh") && node.contains("extensions") &&
                node.at("extensions").contains(instancing))
                place_instances(document, n, place);
        } catch (const json::exception&) {
            throw InputError(place +
                             ": a field of its instances is missing or is of another kind; export "
                             "it again.");
        }
        keep_only(root.at("nodes").at(n),
                  {"children", "matrix", "mesh", "rotation", "scale", "translation"});
    }
    if (root.contains("scenes") && !root.at("scenes").empty()) return;
    std::vector<bool> is_child(root.at("nodes").size(), false);
    for (const json& node : root.at("nodes"))
        if (node.contains("children"))
            for (const json& child : node.at("children"))
                if (child.get<std::size_t>() < is_child.size())
                    is_child[child.get<std::size_t>()] = true;
    json roots = json::array();
    for (std::size_t n = 0; n < is_child.size(); ++n)
        if (!is_child[n]) roots.push_back(n);
    root["scenes"] = json::array({{{"nodes", std::move(roots)}}});
    root["scene"] = std::size_t{0};
}

std::vector<std::string> left_out_of(GltfDocument& document) {
    bool skins = false, targets = false;
    if (document.root.contains("nodes"))
        for (const json& node : document.root.at("nodes"))
            skins = skins || (node.contains("skin") && node.contains("mesh"));
    for_each_primitive(document, [&](const json& primitive, const std::string&) {
        targets = targets || primitive.contains("targets");
    });
    std::vector<std::string> left_out;
    if (skins) left_out.emplace_back("skins");
    if (targets) left_out.emplace_back("morph targets");
    return left_out;
}

/// A chunk of a .glb, filled up to a whole number of words.
std::string chunk(const char* type, std::string_view bytes, char filling) {
    const std::size_t size = (bytes.size() + 3) / 4 * 4;
    std::string text;
    for (std::size_t b = 0; b < 4; ++b) text += static_cast<char>(size >> (8 * b) & 255);
    text.append(type, 4).append(bytes).append(size - bytes.size(), filling);
    return text;
}

std::string glb_of(const std::string& text, std::string_view binary) {
    std::string chunks = chunk("JSON", text, ' ');
    if (!binary.empty()) chunks += chunk("BIN\0", binary, '\0');
    std::string bytes = std::string("glTF\2\0\0\0", 8);
    const std::size_t size = chunks.size() + 12;
    for (std::size_t b = 0; b < 4; ++b) bytes += static_cast<char>(size >> (8 * b) & 255);
    return bytes + chunks;
}

}  // namespace

std::optional<PlainFile> plain_gltf(std::string_view bytes, const std::string& name) {
    const GltfParts parts = gltf_parts(bytes);
    const std::size_t last = parts.text.find_last_not_of(" \t\r\n");
    if (last == std::string_view::npos) return std::nullopt;
    if (parts.text[last] != '}')
        throw InputError(name +
                         ": the file is cut off, since its JSON has no end; export it again.");
    GltfDocument document{parse_json(parts.text, name), parts.binary, name};
    json& root = document.root;
    // glTF 1 names its meshes by the keys of an object.
    if (!root.is_object() || !root.contains("meshes") || !root.at("meshes").is_array())
        return std::nullopt;
    const bool has_chunks = bytes.starts_with("glTF");
    check_gltf(document, has_chunks);
    PlainFile plain{"", left_out_of(document)};
    WrittenAccessors written(document);
    for_each_primitive(document, [&](json& primitive, const std::string& place) {
        write_out(written, document, primitive, place);
    });
    plain_nodes(document);
    written.add_buffers();
    for (json& mesh : root.at("meshes"))
        if (mesh.is_object()) keep_only(mesh, {"primitives"});
    for (const char* list : {"extensionsUsed", "extensionsRequired"})
        if (root.contains(list)) {
            const json& names = root.at(list);
            root[list] = std::find(names.begin(), names.end(), draco) == names.end()
                             ? json::array()
                             : json::array({draco});
        }
    keep_only(root, {"asset", "scene", "scenes", "nodes", "meshes", "accessors", "bufferViews",
                     "buffers", "extensionsUsed", "extensionsRequired"});
    plain.bytes = root.dump();
    if (has_chunks) plain.bytes = glb_of(plain.bytes, parts.binary);
    return plain;
}

}  // namespace scb::scenes
