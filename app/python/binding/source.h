#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "app/python/binding/errors.h"
#include "app/query/query_options.h"
#include "app/query/scene_options.h"

namespace scb::python {

/// A path, str or os.PathLike. Throws what Python does where it is neither.
std::filesystem::path file_of(const py::handle& object);

/// What a SCENE of the command line is here: a Scene, a name or path, or a list of one or two.
/// Meshes of built-in scenes are looked for where the environment variable SCB_MODELS says.
app::SceneOptions source_of(const py::handle& object);

/// Names as the command line has them. Throws InputError where there is none such.
app::HierarchyOptions hierarchy_options(const std::string& volumes, const std::string& split,
                                        const std::string& growth, double margin);
app::QueryOptions query_options(const std::string& test, double threshold,
                                const std::string& descent, const std::string& bodies = "",
                                const std::string& frames = "all");
/// None: those of the command line, which end a query at 100,000,000 pairs.
app::QueryLimits query_limits(std::optional<std::int64_t> max_pairs,
                              std::optional<std::int64_t> stop_level);
/// How many threads: 0 means as many as there are processors. Throws InputError below 0.
int threads_of(std::int64_t threads);

}  // namespace scb::python
