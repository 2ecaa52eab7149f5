#pragma once

#include <memory>
#include <set>

#include "app/python/binding/arrays.h"
#include "core/analysis/ending.h"
#include "core/analysis/pass_counts.h"

namespace scb::python {

/// One query with all its tests, with the engine's node numbers. Owns a copy, since sources reuse
/// their memory.
class FrameTests {
  public:
    FrameTests(const TraceHeader& header, const QueryTrace& frame);

    const QueryTrace& frame() const { return all_->frame; }
    /// Per test of volumes, in the order of the tests.
    py::array node_a() const;
    py::array node_b() const;
    py::array depth_a() const;
    py::array depth_b() const;
    py::array outcome() const;
    py::array parent() const;
    /// Per test of triangles.
    py::array triangle_a() const;
    py::array triangle_b() const;
    py::array intersect() const;

    py::array pairs() const;
    /// Names of the outcomes that occur, by number.
    py::dict outcome_names() const;
    py::dict stages() const;

  private:
    struct All {
        TraceHeader header;
        QueryTrace frame;
        Outcomes outcomes;
        std::set<Stage> occurring;  ///< in `outcomes`
    };
    std::shared_ptr<const All> all_;

    template <class Element, class Number>
    py::array column(const std::vector<Element>& elements, const Number& first) const;
};

void add_query_frame(py::module_& module);

}  // namespace scb::python
