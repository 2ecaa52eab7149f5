#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/pictures/query_view_options.h"
#include "app/query/query_sources.h"
#include "render/figures/rejections_figure.h"

namespace scb::app {

/// What `scb render rejections` understands.
struct RejectionsOptions : QueryViewOptions {
    render::NodeColor by = render::NodeColor::dominant;
    std::string stages, depths, body;
    double opacity = 1;
    bool nested = false;
    std::optional<double> focus;
    std::optional<std::int64_t> steps;

    /// Throws InputError where these queries have no such endings, levels or bodies.
    render::RejectionsStyle style(const QuerySources& sources) const;
    /// A subtitle, and which nodes are shown, where not all are.
    std::string filtered(std::string subtitle) const;
    /// What the pictures are, for their titles.
    std::string title() const;
    /// Those that are not as by default, for the names of files.
    NamedOptions changed() const;
};

void add_rejections_options(const Command& command, RejectionsOptions& options);

}  // namespace scb::app
