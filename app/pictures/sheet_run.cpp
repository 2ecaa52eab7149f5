#include "app/pictures/sheet_run.h"

#include <nlohmann/json.hpp>

#include "core/base/text_format.h"
#include "render/draw/image_operations.h"
#include "render/overlay/figure_layout.h"

namespace scb::app {

void SheetRun::explain(const std::string& title, const std::vector<render::PanelItem>& panel) {
    sheet.title = title;
    render::add_legend(sheet, panel);
    scale_end = render::scale_end(panel);
}

nlohmann::ordered_json SheetRun::explanation() const {
    nlohmann::ordered_json json = {{"title", sheet.title},
                                   {"keys", nlohmann::ordered_json::array()}};
    for (const render::PanelKey& key : sheet.keys)
        json["keys"].push_back(
            {{"color", {key.color.r, key.color.g, key.color.b, key.color.a}}, {"text", key.text}});
    if (sheet.scale) json["scale"] = {{"title", sheet.scale->title}, {"ticks", sheet.scale->ticks}};
    return json;
}

void SheetRun::explain(const nlohmann::ordered_json& explanation) {
    std::vector<render::PanelItem> panel;
    for (const auto& key : explanation.at("keys")) {
        const auto color = key.at("color").get<std::array<std::uint8_t, 4>>();
        panel.push_back(render::PanelKey{{color[0], color[1], color[2], color[3]},
                                         key.at("text").get<std::string>()});
    }
    if (explanation.contains("scale")) {
        const auto& scale = explanation["scale"];
        panel.push_back(render::PanelScale{
            scale.at("title").get<std::string>(),
            scale.at("ticks").get<std::vector<std::pair<double, std::string>>>()});
    }
    explain(explanation.at("title").get<std::string>(), panel);
}

render::Image SheetRun::shrunk(const render::Image& picture) const {
    return render::shrunk(picture, view, sheet.layout.view_width, sheet.layout.view_height);
}

void SheetRun::add(render::Image view_of_cell, const nlohmann::ordered_json& entry) {
    const auto count = [&](const char* key) {
        if (!entry.contains("queries")) return render::count_text(entry[key].get<std::uint64_t>());
        const auto& queries = entry["queries"];
        return render::count_text(queries[0][key].get<std::uint64_t>()) + " / " +
               render::count_text(queries[1][key].get<std::uint64_t>());
    };
    render::FrameSheetCell cell;
    if (!entry.contains("tests") || !one_frame) cell.caption = "frame " + entry["frame"].dump();
    if (entry.contains("tests"))
        cell.caption += (cell.caption.empty() ? "test " : ", test ") + count("tests");
    if (entry.contains("distance"))
        cell.value = entry["distance"].is_null() ? std::string("none")
                                                 : format("%.6g", entry["distance"].get<double>());
    else
        cell.value = count("pairs") + (entry.value("pairs", 0) == 1 ? " pair" : " pairs");
    cell.details = {"N_v " + count("n_v"), "N_p " + count("n_p")};
    cell.scale_end = scale_end;
    cell.view = std::move(view_of_cell);
    sheet.cells.push_back(std::move(cell));
}

}  // namespace scb::app
