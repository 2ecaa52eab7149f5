#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/platform/base64.h"
#include "golden/compare/id_difference.h"
#include "golden/report/report_values.h"
#include "render/files/image_file.h"
#include "scb/error.h"

namespace scb::golden::report {
namespace {

namespace fs = std::filesystem;
using kainjow::mustache::data;

struct Png {
    std::vector<std::uint8_t> bytes;
    int width = 0, height = 0;
};

/// The bytes of a PNG file, or nothing if the file is not a PNG.
std::optional<Png> png_file(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    Png png;
    png.bytes.assign(std::istreambuf_iterator<char>(file), {});
    constexpr std::string_view start("\x89PNG\r\n\x1a\n", 8);
    // The size is in the first chunk, which has a fixed place.
    if (png.bytes.size() < 24 ||
        !std::equal(start.begin(), start.end(), png.bytes.begin(),
                    [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; }))
        return std::nullopt;
    const auto number = [&](std::size_t at) {
        std::uint32_t n = 0;
        for (std::size_t i = at; i < at + 4; ++i) n = n << 8 | png.bytes[i];
        return static_cast<int>(std::min<std::uint32_t>(n, 1u << 20));
    };
    png.width = number(16);
    png.height = number(20);
    if (png.width == 0 || png.height == 0) return std::nullopt;
    return png;
}

Png png_of(const render::Image& image) {
    return {render::encode_png(image), image.width, image.height};
}

struct Pane {
    const char* kind;   ///< also of the styles and the script
    const char* title;  ///< for people
    std::string path;   ///< empty: there is none
    std::optional<Png> png;
    std::vector<PixelBox> small_changes{};  ///< of a difference, to be ringed
};

/// The clusters of changed pixels that are easily overlooked.
std::vector<PixelBox> small_changes(const render::Image& difference) {
    constexpr std::size_t most_clusters = 16;
    constexpr int small = 8;  // a part of the picture's width
    std::vector<PixelBox> clusters = changed_clusters(difference, most_clusters);
    std::erase_if(clusters, [&](const PixelBox& box) {
        return small * std::max(box.right - box.left, box.bottom - box.top) > difference.width;
    });
    return clusters;
}

std::vector<Pane> panes_of(const ResultPictures& pictures, const fs::path& folder, bool ids) {
    std::vector<Pane> panes{{"baseline", "baseline", pictures.baseline, {}},
                            {"candidate", "new", pictures.candidate, {}},
                            {"difference", "difference", pictures.difference, {}}};
    for (Pane& pane : panes)
        if (!pane.path.empty()) pane.png = png_file(folder / pane.path);
    if (!ids) {
        if (panes[2].png) try {
                panes[2].small_changes =
                    small_changes(render::read_png(folder / pictures.difference));
            } catch (const InputError&) {
                panes[2].png.reset();
            }
        return panes;
    }
    std::array<std::optional<render::IdImage>, 2> owners;
    for (std::size_t i = 0; i < 2; ++i) {
        if (!panes[i].png) continue;
        try {
            owners[i] = render::unpack_ids(render::read_png(folder / panes[i].path));
            panes[i].png = png_of(shown_ids(*owners[i]));
        } catch (const InputError&) {
            panes[i].png.reset();
        }
    }
    if (panes[2].path.empty() && owners[0] && owners[1] && owners[0]->width == owners[1]->width &&
        owners[0]->height == owners[1]->height) {
        const render::Image difference = shown_id_difference(*owners[0], *owners[1]);
        panes[2].png = png_of(difference);
        panes[2].small_changes = small_changes(difference);
    }
    return panes;
}

struct PictureSet {
    const char* id;     ///< also of the styles and the script
    const char* title;  ///< of the button that shows it
    const ResultPictures& pictures;
    PixelBox box;
};

/// Appends a picture in its versions, if there is any.
void append_pictures(data& sets, const PictureSet& set, const CaseResult& result,
                     const fs::path& folder) {
    const bool ids = std::string_view(set.id) == "ids";
    const std::vector<Pane> panes = panes_of(set.pictures, folder, ids);
    int width = 0, height = 0;
    for (const Pane& pane : panes)
        if (pane.png) {
            width = std::max(width, pane.png->width);
            height = std::max(height, pane.png->height);
        }
    data figures(data::type::list);
    bool any = false;
    for (const Pane& pane : panes) {
        if (pane.path.empty() && !pane.png) continue;
        any = true;
        data figure;
        figure["kind"] = pane.kind;
        figure["pane"] = pane.title;
        figure["has_image"] = flag(pane.png.has_value());
        figure["path"] = pane.path;
        figure["alt"] = std::string(ids ? "the node or triangle at each pixel of " : "") +
                        result.name + ", " + pane.title;
        // Every version is drawn at one scale, also if the sizes differ.
        if (pane.png) {
            figure["url"] = "data:image/png;base64," + base64(pane.png->bytes);
            figure["width"] = std::to_string(pane.png->width);
            figure["height"] = std::to_string(pane.png->height);
            figure["size"] =
                std::to_string(pane.png->width) + " × " + std::to_string(pane.png->height);
            figure["share"] = percent(pane.png->width, width);
        }
        data rings(data::type::list);
        for (const PixelBox& box : pane.small_changes) {
            data ring;
            ring["x"] = percent(box.left + box.right, 2 * width);
            ring["y"] = percent(box.top + box.bottom, 2 * height);
            ring["size"] = percent(std::max(box.right - box.left, box.bottom - box.top), width);
            rings << ring;
        }
        figure.set("rings", rings);
        figures << figure;
    }
    if (!any) return;
    data entry;
    entry["set"] = set.id;
    entry["set_title"] = set.title;
    entry["set_note"] =
        ids ? "Each thing has a color of its own; these are not the picture's colors." : "";
    entry["has_set_note"] = flag(ids);
    entry["set_width"] = std::to_string(std::max(width, 1));
    entry["set_height"] = std::to_string(std::max(height, 1));
    entry["comparable"] = flag(panes[0].png && panes[1].png);
    entry["box"] = box_numbers(set.box);
    entry["has_box"] = flag(!set.box.empty() && width > 0);
    entry["box_left"] = percent(set.box.left, width);
    entry["box_top"] = percent(set.box.top, height);
    entry["box_width"] = percent(set.box.right - set.box.left, width);
    entry["box_height"] = percent(set.box.bottom - set.box.top, height);
    entry["first"] = flag(sets.is_empty_list());
    entry.set("figures", figures);
    sets << entry;
}

}  // namespace

data pictures_of(const CaseResult& result, const fs::path& folder) {
    data sets(data::type::list);
    append_pictures(sets, {"colors", "picture", result.picture, result.focus}, result, folder);
    append_pictures(sets,
                    {"ids", "ids", result.id_picture, result.ids ? result.ids->box : PixelBox{}},
                    result, folder);
    return sets;
}

}  // namespace scb::golden::report
