#include "app/query/inside_report.h"

#include <nlohmann/json.hpp>

#include "core/base/text_format.h"

namespace scb::app {

InsideReport::InsideReport(const SceneQuery& query)
    : query_(query),
      bodies_(query.mesh(query.a), *query.topologies[query.scene.bodies[query.a].mesh].topology,
              query.mesh(query.b), *query.topologies[query.scene.bodies[query.b].mesh].topology) {}

const std::string& InsideReport::name(std::size_t side) const {
    return query_.scene.bodies[side == 0 ? query_.a : query_.b].name;
}

nlohmann::ordered_json InsideReport::add(int frame) {
    last_ = bodies_.at(query_.b_to_a(frame));
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (std::size_t side = 0; side < 2; ++side) {
        const PartsInside& found = last_[side];
        whole_[side] += found.inside > 0 && found.inside == found.parts;
        some_[side] += found.inside > 0 && found.inside < found.parts;
        not_judged_[side] += found.not_judged;
        if (found.inside > 0)
            json.push_back({{"frame", frame},
                            {"body", name(side)},
                            {"in", name(1 - side)},
                            {"parts", found.inside},
                            {"of", found.parts}});
    }
    return json;
}

std::string inside_words(const nlohmann::ordered_json& found) {
    std::string text;
    for (const nlohmann::ordered_json& part : found)
        text += (text.empty() ? "" : "; ") +
                std::string(part["parts"] == part["of"] ? "" : "parts of ") +
                part["body"].get<std::string>() + " inside " + part["in"].get<std::string>();
    return text;
}

std::vector<std::string> InsideReport::not_closed() const {
    std::vector<std::string> names;
    for (std::size_t side = 0; side < 2; ++side)
        if (not_judged_[1 - side] > 0) names.push_back(name(side));
    return names;
}

std::string InsideReport::claims(std::size_t frames) const {
    std::string text;
    const auto add_claim = [&](std::size_t count, const std::string& claim) {
        if (count == 0) return;
        text += (text.empty() ? "" : ", and ") + claim +
                (frames == 1 ? "" : format(" in %zu of %zu frames", count, frames));
    };
    for (std::size_t side = 0; side < 2; ++side) {
        const std::string where = " inside " + name(1 - side);
        add_claim(whole_[side], name(side) + " lies" + where);
        const PartsInside& only = last_[side];
        add_claim(some_[side],
                  frames > 1 ? "parts of " + name(side) + " lie" + where
                             : format("%zu of %zu parts of ", only.inside, only.parts) +
                                   name(side) + (only.inside == 1 ? " lies" : " lie") + where);
    }
    return text;
}

std::string InsideReport::doubts() const {
    std::string text;
    for (std::size_t side = 0; side < 2; ++side)
        if (not_judged_[side] > 0)
            text += "Whether " + name(side) + " lies inside " + name(1 - side) +
                    " is not judged: " + name(1 - side) + " is not closed.\n";
    return text;
}

}  // namespace scb::app
