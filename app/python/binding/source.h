#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "app/python/binding/errors.h"
#include "app/study/query_setup.h"

namespace scb::python {

/// A path, from str or os.PathLike. Throws Python's error for other types.
std::filesystem::path file_of(const py::handle& object);

/// The SCENE of a command, from a Scene, a name or path, or a list of one or two. Meshes of
/// built-in scenes are looked up in the folder in the environment variable SCB_MODELS.
app::SceneOptions source_of(const py::handle& object);

/// Options from names as on the command line. Throws InputError if a name is unknown.
app::HierarchyOptions hierarchy_options(const std::string& volumes, const std::string& split,
                                        const std::string& growth, double margin);
app::QueryOptions query_options(const std::string& test, double threshold,
                                const std::string& descent, const std::string& bodies = "",
                                const std::string& frames = "all");
/// None: the limits of the command line, which ends a query at 100,000,000 pairs.
app::QueryLimits query_limits(std::optional<std::int64_t> max_pairs,
                              std::optional<std::int64_t> stop_level);
/// The number of threads; 0 means as many as there are processors. Throws InputError below 0.
int threads_of(std::int64_t threads);

}  // namespace scb::python
