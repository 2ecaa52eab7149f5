#include "app/build_text.h"

#include "app/text_format.h"

namespace scb {

std::string build_text(const BuildOptions& options) {
    const BuildOptions defaults;
    std::string text;
    if (options.fit.growth != defaults.fit.growth)
        text += ", growth " + std::string(ball_growth_name(options.fit.growth));
    if (options.fit.margin != defaults.fit.margin)
        text += format(", margin %g", options.fit.margin);
    if (options.split != defaults.split)
        text += ", split by " + std::string(split_method_name(options.split));
    return text;
}

}  // namespace scb
