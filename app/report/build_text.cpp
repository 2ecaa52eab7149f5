#include "app/report/build_text.h"

#include "core/base/text_format.h"

namespace scb::app {

std::vector<std::string> build_parts(const BuildOptions& options) {
    const BuildOptions defaults;
    std::vector<std::string> parts;
    if (options.fit.growth != defaults.fit.growth)
        parts.push_back("growth " + std::string(ball_growth_name(options.fit.growth)));
    if (options.fit.margin != defaults.fit.margin)
        parts.push_back(format("margin %g", options.fit.margin));
    if (options.split != defaults.split)
        parts.push_back("split by " + std::string(split_method_name(options.split)));
    return parts;
}

std::string build_text(const BuildOptions& options) {
    std::string text;
    for (const std::string& part : build_parts(options)) text += ", " + part;
    return text;
}

std::string build_sentence(const BuildOptions& options) {
    const std::string text = build_text(options);
    return text.empty() ? "" : "Hierarchies: " + text.substr(2) + ".";
}

}  // namespace scb::app
