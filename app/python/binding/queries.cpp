#include "app/python/binding/queries.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <mutex>
#include <utility>

#include "app/python/binding/query_frame.h"
#include "app/python/binding/scene.h"
#include "app/python/binding/source.h"
#include "app/study/query_source.h"
#include "core/base/text_format.h"

namespace scb::python {
namespace {

/// The parameters of a source of queries. The source may have to be opened again, since files are
/// read forward.
struct Asked {
    app::SceneOptions scene;
    app::HierarchyOptions hierarchy;
    app::QueryOptions query;
    app::QueryLimits limits;
    bool recorded = true;
};

class Queries {
  public:
    explicit Queries(Asked asked) : asked_(std::move(asked)) { open(); }

    /// Returns `use(source)`, under the lock, since another thread may open the source again.
    template <class Use>
    auto with_source(const Use& use) const {
        const std::lock_guard lock(mutex_);
        return use(std::as_const(*source_));
    }

    FrameTests frame(std::int64_t number) {
        const std::lock_guard lock(mutex_);
        const QueryTrace& frame = seek(number);  // may replace the source
        return FrameTests(source_->header(), frame);
    }
    PassCounts waste(std::int64_t number) {
        const std::lock_guard lock(mutex_);
        const QueryTrace& frame = seek(number);
        return source_->attribution(frame).counts;
    }

  private:
    void open() {
        source_ = std::make_unique<app::QuerySource>(asked_.scene, asked_.hierarchy, asked_.query,
                                                     asked_.limits, asked_.recorded);
        last_ = -1;
    }
    /// The query of a frame; valid until the next call.
    const QueryTrace& seek(std::int64_t number) {
        const std::vector<int>& frames = source_->frames();
        if (!std::binary_search(frames.begin(), frames.end(), number))
            refuse("frame " + std::to_string(number),
                   "there is no query of it; there are queries of " +
                       name_list(frames, [](int f) { return std::to_string(f); }) + ".");
        if (number <= last_) open();
        const QueryTrace& frame = source_->frame(static_cast<int>(number));
        last_ = number;
        return frame;
    }

    Asked asked_;
    std::unique_ptr<app::QuerySource> source_;
    std::int64_t last_ = -1;
    mutable std::mutex mutex_;
};

/// Returns a copy, so that no Python code runs under the lock.
TraceHeader header_of(const Queries& queries) {
    return queries.with_source([](const app::QuerySource& source) { return source.header(); });
}
std::vector<int> frames_of(const Queries& queries) {
    return queries.with_source([](const app::QuerySource& source) { return source.frames(); });
}

py::dict settings_of(const Queries& queries) {
    py::dict settings;
    for (const TraceField& field : fields_of(header_of(queries)))
        settings[py::str(field.name)] = field.value;
    return settings;
}

}  // namespace

void add_queries(py::module_& module) {
    add_query_frame(module);
    using Unlocked = py::call_guard<py::gil_scoped_release>;
    py::class_<Queries>(module, "Queries", py::is_final(),
                        R"(Queries of two bodies with all their tests, frame by frame.

Made now, read from a trace, or from another engine's recording: which of them is no matter.)")
        .def_property_readonly("frames", frames_of, "The numbers of the frames, ascending.")
        .def_property_readonly(
            "bodies", [](const Queries& q) { return body_names(header_of(q)); },
            "The names of a and b.")
        .def_property_readonly("settings", settings_of, "What was asked, name by name, as text.")
        .def_property_readonly(
            "is_recording",
            [](const Queries& q) {
                return q.with_source(
                    [](const app::QuerySource& source) { return source.is_recording(); });
            },
            "Whether another engine made the queries.")
        .def(
            "frame", &Queries::frame, py::arg("frame"), Unlocked(),
            R"(The query of one of the frames. A file is read forward: ask ascending where it is long.

Raises InputError where there is no such frame, or the file is broken.)")
        .def("waste", &Queries::waste, py::arg("frame"), Unlocked(),
             R"(What the tests of a frame were worth, by the exact verdict on each pair of volumes.

Takes microseconds for each test. Raises InputError as frame does.)")
        .def("__len__", [](const Queries& q) { return frames_of(q).size(); })
        .def("__repr__", [](const Queries& q) {
            return "<scb.Queries of '" + header_of(q).scene +
                   "': " + std::to_string(frames_of(q).size()) + " frames>";
        });
    module.def(
        "open_queries",
        [](const py::object& source, const std::string& frames, const std::string& bodies,
           bool recorded, const std::string& volume, const std::string& split,
           const std::string& growth, double margin, const std::string& test, double threshold,
           const std::string& descent, std::optional<std::int64_t> max_pairs,
           std::optional<std::int64_t> stop_level) {
            Asked asked{source_of(source), hierarchy_options(volume, split, growth, margin),
                        query_options(test, threshold, descent, bodies, frames),
                        query_limits(max_pairs, stop_level), recorded};
            const py::gil_scoped_release unlocked;
            return std::make_unique<Queries>(std::move(asked));
        },
        py::arg("source"), py::kw_only(), py::arg("frames") = "all", py::arg("bodies") = "",
        py::arg("recorded") = true, py::arg("volume") = "scb", py::arg("split") = "paper",
        py::arg("growth") = "ritter", py::arg("margin") = 0.0, py::arg("test") = "symmetric",
        py::arg("threshold") = 0.7, py::arg("descent") = "radius",
        py::arg("max_pairs") = py::none(), py::arg("stop_level") = py::none(),
        R"(Open the queries of a scene, a trace or a recording (both .scbrec).

source: a Scene, a built-in name, a path, or two mesh files. frames: "all", "auto" or a list such as
"0:499:10,7". bodies: "A,B", where there are more than two. A trace knows all that follows, and so does
a recording; with recorded=False its meshes and poses are asked anew. The rest is as in build and
collide.

Raises InputError.)");
}

}  // namespace scb::python
