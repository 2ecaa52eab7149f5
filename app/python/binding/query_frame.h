#pragma once

#include <memory>
#include <set>

#include "app/python/binding/arrays.h"
#include "core/analysis/ending.h"
#include "core/analysis/pass_counts.h"

namespace scb::python {

/// One query with all its tests, which name nodes by their numbers. Owns a copy: sources use their
/// memory again.
class FrameTests {
  public:
    FrameTests(const TraceHeader& header, const TraceFrame& frame);

    const TraceFrame& frame() const { return all_->frame; }
    /// Of each test of volumes, in the order in which they were made.
    py::array node_a() const;
    py::array node_b() const;
    py::array depth_a() const;
    py::array depth_b() const;
    py::array outcome() const;
    py::array parent() const;
    /// Of each test of triangles.
    py::array triangle_a() const;
    py::array triangle_b() const;
    py::array intersect() const;

    py::array pairs() const;
    /// Outcomes by their numbers, those that a test has.
    py::dict outcome_names() const;
    py::dict stages() const;

  private:
    struct All {
        TraceHeader header;
        TraceFrame frame;
        Outcomes outcomes;
        std::set<Stage> occurring;  ///< of these
    };
    std::shared_ptr<const All> all_;

    template <class Element, class Number>
    py::array column(const std::vector<Element>& elements, const Number& first) const;
};

void add_query_frame(py::module_& module);

}  // namespace scb::python
