#include "scenes/meshes/ply_mesh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/text_format.h"
#include "core/platform/tokens.h"
#include "scb/error.h"
#include "scenes/meshes/ply_header.h"
#include "scenes/meshes/polygon.h"

namespace scb::scenes {
namespace {

constexpr std::uint64_t most = std::uint64_t{1} << 28;

/// The numbers behind the header, one after the other. `ok` becomes false at the end of the file
/// and at a word that is not a number.
class PlyNumbers {
  public:
    PlyNumbers(FileWindow& file, PlyEncoding encoding) : file_(file), encoding_(encoding) {}

    bool ok = true;

    double next(const PlyType& type) {
        if (encoding_ == PlyEncoding::text) return text(type);
        const std::string_view bytes = file_.ahead(type.size);
        if (bytes.size() < type.size) return failed();
        const double value = binary(type, bytes.data());
        file_.skip(type.size);
        return value;
    }

    /// Skips unused numbers.
    void skip(const PlyType& type, std::uint64_t count) {
        if (encoding_ != PlyEncoding::text)
            ok = file_.skip_far(count * type.size);  // a list has fewer than 2^32 elements
        else
            for (std::uint64_t i = 0; i < count && ok; ++i) text(type);
    }

    /// The fewest bytes that an element may take.
    std::uint64_t least_bytes(const PlyElement& element) const {
        std::uint64_t sum = 0;
        for (const PlyProperty& property : element.properties)
            sum += encoding_ == PlyEncoding::text ? 2
                   : property.list_length         ? property.list_length->size
                                                  : property.type.size;
        return sum;
    }

  private:
    double failed() {
        ok = false;
        return 0;
    }

    double binary(const PlyType& type, const char* bytes) const {
        std::uint64_t bits = 0;
        if (encoding_ == PlyEncoding::little_endian)
            for (std::size_t i = 0; i < type.size; ++i)
                bits |= std::uint64_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
        else
            for (std::size_t i = 0; i < type.size; ++i)
                bits = bits << 8 | static_cast<unsigned char>(bytes[i]);
        if (type.is_float && type.size == 4)
            return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
        if (type.is_float) return std::bit_cast<double>(bits);
        const std::uint64_t sign = std::uint64_t{1} << (8 * type.size - 1);
        if (type.is_signed)
            return static_cast<double>(static_cast<std::int64_t>((bits ^ sign) - sign));
        return static_cast<double>(bits);
    }

    double text(const PlyType& type) {
        const std::string_view word = next_word();
        float value = 0;
        const char* const end = word.data() + word.size();
        // The float nearest to the decimal number itself, not to the double nearest to it.
        if (type.is_float && type.size == 4)
            if (const auto parsed = std::from_chars(word.data(), end, value);
                parsed.ec == std::errc{} && parsed.ptr == end)
                return static_cast<double>(value);
        const std::optional<double> number = number_in(word);
        if (!number) return failed();
        return type.is_float && type.size == 4 ? static_cast<double>(static_cast<float>(*number))
                                               : *number;
    }

    /// Empty at the end of the file, and if the word is longer than numbers are.
    std::string_view next_word() {
        constexpr std::size_t longest = 512;
        std::string_view ahead = file_.ahead(longest + 1);
        std::size_t start = 0;
        while (start < ahead.size() && Words::is_blank(ahead[start]))
            if (++start == ahead.size()) {
                file_.skip(start);
                ahead = file_.ahead(longest + 1);
                start = 0;
            }
        file_.skip(start);
        ahead = file_.ahead(longest + 1);
        std::size_t size = 0;
        while (size < ahead.size() && !Words::is_blank(ahead[size]))
            if (++size > longest) return {};
        file_.skip(size);
        return ahead.substr(0, size);
    }

    FileWindow& file_;
    PlyEncoding encoding_;
};

enum class Role { vertices, faces, strips, passed_over };

Role role_of(const PlyElement& element) {
    if (element.name == "vertex") return Role::vertices;
    if (element.name == "face") return Role::faces;
    if (element.name == "tristrips") return Role::strips;
    return Role::passed_over;
}

bool names_vertices(const PlyProperty& property) {
    constexpr std::array<std::string_view, 4> names = {"vertex_indices", "vertex_index",
                                                       "vertex_indexes", "vert_indices"};
    return std::find(names.begin(), names.end(), property.name) != names.end();
}

/// The use of a property of an element: an axis, or the list of vertices.
constexpr int unused = -1, vertex_list = 3;

class PlyReader {
  public:
    explicit PlyReader(FileWindow& file)
        : file_(file), header_(read_ply_header(file)), numbers_(file, header_.encoding) {}

    Mesh read() {
        check_header();
        const std::uint64_t start = file_.position();
        const auto vertices = std::find_if(
            header_.elements.begin(), header_.elements.end(),
            [](const PlyElement& element) { return role_of(element) == Role::vertices; });
        const bool late =
            std::any_of(header_.elements.begin(), vertices, [](const PlyElement& element) {
                return role_of(element) == Role::faces || role_of(element) == Role::strips;
            });
        // Polygons are cut once their corners are known.
        if (late) {
            for (auto element = header_.elements.begin(); element <= vertices; ++element)
                read_element(*element, element == vertices ? Role::vertices : Role::passed_over);
            file_.go_to(start);
        }
        for (const PlyElement& element : header_.elements) {
            const Role role = role_of(element);
            read_element(element, late && role == Role::vertices ? Role::passed_over : role);
        }
        // Blanks at the end are also allowed in binary files.
        for (std::string_view rest = file_.ahead(1); !rest.empty(); rest = file_.ahead(1)) {
            if (std::any_of(rest.begin(), rest.end(), [](char c) { return !Words::is_blank(c); }))
                refuse(
                    "something follows all that the header declares, so its counts are wrong; get "
                    "the file again, or repair the header.");
            file_.skip(rest.size());
        }
        return std::move(mesh_);
    }

  private:
    [[noreturn]] void refuse(const std::string& sentence) const {
        throw InputError(file_.name() + ": " + sentence);
    }

    /// The use of each property of an element. Each use occurs at most once.
    std::vector<int> uses(const PlyElement& element) const {
        constexpr std::array<std::string_view, 3> axes = {"x", "y", "z"};
        const Role role = role_of(element);
        std::vector<int> found;
        for (const PlyProperty& property : element.properties) {
            int use = unused;
            if (role == Role::vertices && !property.list_length)
                for (int axis = 0; axis < 3; ++axis)
                    if (property.name == axes[static_cast<std::size_t>(axis)]) use = axis;
            if ((role == Role::faces || role == Role::strips) && property.list_length &&
                names_vertices(property))
                use = vertex_list;
            if (use != unused && std::find(found.begin(), found.end(), use) != found.end())
                refuse("the header's " + element.name + " element has " +
                       (use == vertex_list ? "two lists of vertices"
                                           : "the property " + property.name + " twice") +
                       "; keep one of them.");
            found.push_back(use);
        }
        return found;
    }

    void check_header() {
        std::uint64_t faces = 0;
        std::array<bool, 3> seen{};
        for (const PlyElement& element : header_.elements) {
            const Role role = role_of(element);
            // An element without properties takes no bytes, so its count would go unchecked.
            if (element.properties.empty() && element.count > 0)
                refuse("the header declares element " + excerpt(element.name) +
                       " without any property; repair the header.");
            if (element.count > most)
                refuse("the header declares " + std::to_string(element.count) +
                       " elements of the kind " + excerpt(element.name) + ", and at most " +
                       std::to_string(most) + " are read; give a smaller mesh.");
            if (role == Role::passed_over) continue;
            if (std::exchange(seen[static_cast<std::size_t>(role)], true))
                refuse("the header declares element " + element.name + " twice; keep one of them.");
            const std::vector<int> use = uses(element);
            const auto has = [&](int wanted) {
                return std::find(use.begin(), use.end(), wanted) != use.end();
            };
            if (role == Role::vertices) {
                vertices_ = element.count;
                for (int axis = 0; axis < 3; ++axis)
                    if (!has(axis))
                        refuse(std::string("the header's vertex element has no property ") +
                               "xyz"[axis] + "; add it.");
            } else {
                if (element.count > 0 && !has(vertex_list))
                    refuse("the header's " + element.name +
                           " element has no list vertex_indices; add it.");
                faces += element.count;
            }
        }
        if (vertices_ == 0 || faces == 0)
            refuse("the mesh has no triangles; give a surface, not points or lines.");
    }

    std::string place(const PlyElement& element, std::uint64_t i) const {
        return excerpt(element.name) + " " + std::to_string(i);
    }

    void read_element(const PlyElement& element, Role role) {
        const std::vector<int> use = role == Role::passed_over
                                         ? std::vector<int>(element.properties.size(), unused)
                                         : uses(element);
        const std::uint64_t room =
            file_.left() / std::max<std::uint64_t>(1, numbers_.least_bytes(element)) + 1;
        if (role == Role::vertices) mesh_.vertices.reserve(std::min(element.count, room));
        if (role == Role::faces) mesh_.triangles.reserve(std::min(element.count, room));
        Vec3 vertex = Vec3::Zero();
        for (std::uint64_t i = 0; i < element.count; ++i) {
            for (std::size_t p = 0; p < use.size(); ++p) {
                const PlyProperty& property = element.properties[p];
                if (property.list_length)
                    read_list(element, i, property,
                              use[p] == vertex_list ? role : Role::passed_over);
                else if (use[p] != unused)
                    vertex[use[p]] = numbers_.next(property.type);
                else
                    numbers_.skip(property.type, 1);
                if (!numbers_.ok)
                    refuse(place(element, i) + " of the " + std::to_string(element.count) +
                           " that the header declares is missing or is not made of numbers; the "
                           "file is cut off or its header is wrong, so get it again.");
            }
            if (role == Role::vertices) mesh_.vertices.push_back(vertex);
            if (role == Role::faces) append_face(element, i);
            if (role == Role::strips) append_strip();
        }
    }

    /// Reads a list; the list of vertices becomes corners_.
    void read_list(const PlyElement& element, std::uint64_t i, const PlyProperty& property,
                   Role role) {
        const double length = numbers_.next(*property.list_length);
        if (!numbers_.ok) return;
        if (!(length >= 0 && length == std::floor(length) && length <= 4294967295.0))
            refuse(place(element, i) +
                   " has a list with a length that is not a whole number from 0; repair it.");
        const auto count = static_cast<std::uint64_t>(length);
        if (role == Role::passed_over) {
            numbers_.skip(property.type, count);
            return;
        }
        all_corners_ += count;
        if (all_corners_ > most)
            refuse("its faces have more than " + std::to_string(most) +
                   " corners; give a smaller mesh.");
        corners_.clear();
        for (std::uint64_t k = 0; k < count; ++k) {
            const double index = numbers_.next(property.type);
            if (!numbers_.ok) return;
            const bool restart = role == Role::strips && index == -1;
            if (!restart && !(index >= 0 && index < static_cast<double>(vertices_) &&
                              index == std::floor(index)))
                refuse(place(element, i) + " names vertex " + exact_number(index) +
                       ", but there are " + std::to_string(vertices_) +
                       " vertices, numbered from 0; repair the index.");
            corners_.push_back(restart ? strip_end : static_cast<std::uint32_t>(index));
        }
    }

    void append_face(const PlyElement& element, std::uint64_t i) {
        if (corners_.size() == 3)  // for speed: no name is made
            mesh_.triangles.push_back({corners_[0], corners_[1], corners_[2]});
        else
            cutter_.append(corners_, mesh_.vertices, file_.name() + ": " + place(element, i),
                           mesh_.triangles);
    }

    /// Every second triangle of a strip has the opposite orientation.
    void append_strip() {
        std::size_t start = 0;
        for (std::size_t k = 0; k < corners_.size(); ++k) {
            if (corners_[k] == strip_end) start = k + 1;
            if (k < start + 2) continue;
            Triangle t = {corners_[k - 2], corners_[k - 1], corners_[k]};
            if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
            if ((k - start) % 2 == 1) std::swap(t[0], t[1]);
            mesh_.triangles.push_back(t);
        }
    }

    static constexpr std::uint32_t strip_end = 0xffffffff;

    FileWindow& file_;
    PlyHeader header_;
    PlyNumbers numbers_;
    Mesh mesh_;
    PolygonCutter cutter_;
    std::uint64_t vertices_ = 0, all_corners_ = 0;
    std::vector<std::uint32_t> corners_;  ///< of the current face or strip
};

}  // namespace

Mesh ply_mesh(const std::string& path) {
    FileWindow file(path);
    return PlyReader(file).read();
}

}  // namespace scb::scenes
