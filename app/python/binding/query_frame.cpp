#include "app/python/binding/query_frame.h"

#include <pybind11/stl.h>

namespace scb::python {
namespace {

const Step no_volume_test{};
const ItemStep no_triangle_test{};

template <class Element>
const Element& first_of(const std::vector<Element>& elements, const Element& none) {
    return elements.empty() ? none : elements[0];
}

}  // namespace

FrameTests::FrameTests(const TraceHeader& header, const QueryTrace& frame)
    : all_([&] {
          auto all = std::make_shared<All>(All{header, frame, outcomes_of(header, frame), {}});
          QueryTrace& told = all->frame;
          for (Step& test : told.steps.volumes) test.nodes = numbers_of(frame, test.nodes);
          if (pairs_are_nodes(header))
              for (IndexPair& pair : told.found.pairs) pair = numbers_of(frame, pair);
          told.trees = {};
          all->occurring.insert(all->outcomes.begin(), all->outcomes.end());
          return all;
      }()) {}

/// An array of one number of each element; `first`: the number in the first element.
template <class Element, class Number>
py::array FrameTests::column(const std::vector<Element>& elements, const Number& first) const {
    return view_of(py::dtype::of<Number>(), &first, {static_cast<py::ssize_t>(elements.size())},
                   {static_cast<py::ssize_t>(sizeof(Element))}, all_);
}

py::array FrameTests::node_a() const {
    const std::vector<Step>& tests = frame().steps.volumes;
    return column(tests, first_of(tests, no_volume_test).nodes.a);
}
py::array FrameTests::node_b() const {
    const std::vector<Step>& tests = frame().steps.volumes;
    return column(tests, first_of(tests, no_volume_test).nodes.b);
}
py::array FrameTests::depth_a() const {
    const std::vector<Step>& tests = frame().steps.volumes;
    return column(tests, first_of(tests, no_volume_test).depth_a);
}
py::array FrameTests::depth_b() const {
    const std::vector<Step>& tests = frame().steps.volumes;
    return column(tests, first_of(tests, no_volume_test).depth_b);
}
py::array FrameTests::outcome() const {
    const Outcomes& outcomes = all_->outcomes;
    return view_of(py::dtype::of<std::uint8_t>(), outcomes.data(),
                   {static_cast<py::ssize_t>(outcomes.size())}, {1}, all_);
}
py::array FrameTests::parent() const {
    const std::vector<Step>& steps = frame().steps.volumes;
    return column(steps, first_of(steps, no_volume_test).parent);
}
py::array FrameTests::triangle_a() const {
    const std::vector<ItemStep>& tests = frame().steps.items;
    return column(tests, first_of(tests, no_triangle_test).items.a);
}
py::array FrameTests::triangle_b() const {
    const std::vector<ItemStep>& tests = frame().steps.items;
    return column(tests, first_of(tests, no_triangle_test).items.b);
}
py::array FrameTests::intersect() const {
    const std::vector<ItemStep>& tests = frame().steps.items;
    return column(tests, first_of(tests, no_triangle_test).hit);
}
py::array FrameTests::pairs() const {
    const std::vector<IndexPair>& pairs = frame().found.pairs;
    return view_of(py::dtype::of<std::uint32_t>(), pairs.data(),
                   {static_cast<py::ssize_t>(pairs.size()), 2}, {8, 4}, all_);
}

py::dict FrameTests::outcome_names() const {
    py::dict names;
    for (const Stage outcome : all_->occurring)
        names[py::int_(static_cast<int>(outcome))] = stage_words(all_->header, outcome);
    return names;
}

py::dict FrameTests::stages() const {
    py::dict stages;
    for (const auto& [name, count] : tests_by_stage(all_->header, frame()))
        stages[py::str(name)] = count;
    return stages;
}

void add_query_frame(py::module_& module) {
    py::class_<FrameTests> type(module, "QueryFrame", py::is_final(),
                                R"(One query with all its tests.

Arrays are read-only and no copies. Those of tests of volumes have an entry per test, in the order in
which they were made; so have those of tests of triangles.)");
    type.def_property_readonly(
            "frame", [](const FrameTests& f) { return f.frame().frame; }, "Its number.")
        .def_property_readonly(
            "pose", [](const FrameTests& f) { return matrix_of(f.frame().b_to_a); },
            "4 x 4 float64, from b's frame to a's.")
        .def_property_readonly("node_a", &FrameTests::node_a,
                               "uint32: the number of the node of a; of a recording, its engine's.")
        .def_property_readonly("node_b", &FrameTests::node_b, "uint32: the same of b.")
        .def_property_readonly("depth_a", &FrameTests::depth_a, "uint16: the depth of node_a.")
        .def_property_readonly("depth_b", &FrameTests::depth_b, "uint16: the depth of node_b.")
        .def_property_readonly("outcome", &FrameTests::outcome,
                               "uint8: what became of the pair; see outcome_names.")
        .def_property_readonly("outcome_names", &FrameTests::outcome_names,
                               "The outcomes that there are, by their numbers.")
        .def_property_readonly(
            "parent", &FrameTests::parent,
            "uint32: the test whose pair was divided for this one; 0xffffffff of the first.")
        .def_property_readonly("triangle_a", &FrameTests::triangle_a, "uint32: the triangle of a.")
        .def_property_readonly("triangle_b", &FrameTests::triangle_b, "uint32: the triangle of b.")
        .def_property_readonly("intersect", &FrameTests::intersect,
                               "bool: whether the two triangles intersect.")
        .def_property_readonly("pairs", &FrameTests::pairs, "n x 2 uint32: see Collision.pairs.")
        .def_property_readonly("stages", &FrameTests::stages, "See Collision.stages.")
        .def_property_readonly(
            "n_v", [](const FrameTests& f) { return f.frame().found.n_v; }, "Tests of two volumes.")
        .def_property_readonly(
            "n_p", [](const FrameTests& f) { return f.frame().found.n_p; },
            "Tests of two triangles.")
        .def_property_readonly(
            "n_u", [](const FrameTests& f) { return f.frame().found.n_u; },
            "Points and directions transformed.")
        .def_property_readonly(
            "complete", [](const FrameTests& f) { return f.frame().found.complete; },
            "See Collision.complete.")
        .def("__repr__", [](const FrameTests& f) {
            return "<scb.QueryFrame " + std::to_string(f.frame().frame) +
                   ": N_v = " + std::to_string(f.frame().found.n_v) + ", " +
                   std::to_string(f.frame().found.pairs.size()) + " pairs>";
        });
    py::class_<PassCounts>(module, "Waste", py::is_final(),
                           R"(What the tests of a query were worth.

A test is wasted where the pair whose division led to it has no triangles below it that intersect.)")
        .def_property_readonly(
            "volume_tests", [](const PassCounts& c) { return c.all.volume_tests; },
            "All tests of volumes.")
        .def_property_readonly(
            "triangle_tests", [](const PassCounts& c) { return c.all.triangle_tests; },
            "All tests of triangles.")
        .def_property_readonly(
            "wasted_volume_tests", [](const PassCounts& c) { return c.wasted().volume_tests; },
            "Those of volumes that were wasted.")
        .def_property_readonly(
            "wasted_triangle_tests", [](const PassCounts& c) { return c.wasted().triangle_tests; },
            "Those of triangles that were wasted.")
        .def_property_readonly(
            "wasted_by_tests",
            [](const PassCounts& c) { return c.wasted_by(PassReason::weak_test).volume_tests; },
            "Of the wasted ones of volumes, those that an exact overlap test would save.")
        .def_property_readonly(
            "wasted_by_fit",
            [](const PassCounts& c) { return c.wasted_by(PassReason::loose_fit).volume_tests; },
            "Of the wasted ones of volumes, those below volumes that meet though nothing in them "
            "does.")
        .def_readonly("wrongly_rejected", &PassCounts::wrongly_rejected,
                      "Tests that rejected volumes which overlap: errors.")
        .def_readonly("missed", &PassCounts::missed, "Pairs of triangles that were lost by them.")
        .def("__repr__", [](const PassCounts& c) {
            return "<scb.Waste: " + std::to_string(c.wasted().volume_tests) + " of " +
                   std::to_string(c.all.volume_tests) + " volume tests>";
        });
}

}  // namespace scb::python
