#include "app/python/binding/source.h"

#include <algorithm>
#include <cstdlib>

#include "app/python/binding/scene.h"
#include "core/base/parallel_for.h"
#include "core/base/text_format.h"

namespace scb::python {
namespace {

std::string name_of(const py::handle& object) {
    PyObject* bytes = nullptr;
    if (PyUnicode_FSConverter(object.ptr(), &bytes) == 0) throw py::error_already_set();
    return py::reinterpret_steal<py::bytes>(bytes);
}

}  // namespace

std::filesystem::path file_of(const py::handle& object) { return name_of(object); }

app::SceneOptions source_of(const py::handle& object) {
    if (py::isinstance<SharedScene>(object)) return object.cast<const SharedScene&>().options;
    app::SceneOptions options;
    if (const char* models = std::getenv("SCB_MODELS")) options.models_dir = models;
    if (py::isinstance<py::list>(object) || py::isinstance<py::tuple>(object))
        for (const py::handle& each : object) options.names.push_back(name_of(each));
    else
        options.names.push_back(name_of(object));
    if (options.names.empty() || options.names.size() > 2)
        refuse("source", "give one scene, or two files; it has " +
                             std::to_string(options.names.size()) + ".");
    return options;
}

app::HierarchyOptions hierarchy_options(const std::string& volumes, const std::string& split,
                                        const std::string& growth, double margin) {
    app::HierarchyOptions options;
    options.volumes = volumes;
    options.margin = margin;
    options.kinds();
    const std::vector<SplitMethod> splits = app::splits_of(split);
    if (splits.size() != 1) refuse("--split " + split, "give one, paper or cost.");
    options.split = splits[0];
    if (growth == ball_growth_name(BallGrowth::radius))
        options.growth = BallGrowth::radius;
    else if (growth != ball_growth_name(BallGrowth::ritter))
        refuse("--growth " + growth, "give ritter or radius.");
    options.build();  // checks the margin
    return options;
}

app::QueryOptions query_options(const std::string& test, double threshold,
                                const std::string& descent, const std::string& bodies,
                                const std::string& frames) {
    app::QueryOptions options{test, threshold, DescentRule::radius, frames, bodies};
    const std::optional<DescentRule> rule = descent_rule_of(descent);
    if (!rule)
        refuse("--descent " + descent,
               "give one of " + name_list(all_descent_rules(), descent_rule_name) + ".");
    options.descent = *rule;
    options.overlap();
    return options;
}

app::QueryLimits query_limits(std::optional<std::int64_t> max_pairs,
                              std::optional<std::int64_t> stop_level) {
    app::QueryLimits limits;
    if (max_pairs) limits.max_pairs = *max_pairs;
    if (stop_level) limits.levels = std::to_string(*stop_level);
    return limits;
}

int threads_of(std::int64_t threads) {
    if (threads < 0) refuse("threads", "give 0, for one per processor, or more.");
    const int most = processor_count();
    return threads == 0 ? most : static_cast<int>(std::min<std::int64_t>(threads, most));
}

}  // namespace scb::python
