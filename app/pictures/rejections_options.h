#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/pictures/query_view_options.h"
#include "app/study/query_sources.h"
#include "render/figures/rejections_figure.h"

namespace scb::app {

/// Options of `scb render rejections`.
struct RejectionsOptions : QueryViewOptions {
    render::NodeColor by = render::NodeColor::dominant;
    std::string stages, depths, body;
    double opacity = 1;
    bool nested = false;
    std::optional<double> focus;
    std::optional<std::int64_t> steps;

    /// Throws InputError if these queries have no such endings, levels or bodies.
    render::RejectionsStyle style(const QuerySources& sources) const;
    /// The subtitle, with the filter if only some nodes are shown.
    std::string filtered(std::string subtitle) const;
    /// The kind of picture, for titles.
    std::string title() const;
    /// The options that differ from the default, for file names.
    NamedOptions changed() const;
};

void add_rejections_options(const Command& command, RejectionsOptions& options);

}  // namespace scb::app
