#include "app/python/binding/explain.h"

#include <pybind11/stl.h>

#include <nlohmann/json.hpp>

#include "app/explain/explain_report.h"
#include "app/python/binding/arrays.h"
#include "app/python/binding/collide_options.h"

namespace scb::python {
namespace {

using app::ExplainedPair;

ExplainedPair explain_nodes(const BuiltHierarchy& a, std::int64_t node_a, const BuiltHierarchy& b,
                            std::int64_t node_b, const py::object& pose, const std::string& test,
                            double threshold) {
    const Pose b_to_a = pose_of(pose, "pose");
    const CollideArguments asked{test, threshold, "radius", {}, {}};
    const OverlapOptions options = asked.options(a, b).overlap;
    const py::gil_scoped_release unlocked;
    return app::explained_nodes(a.kind, a.hierarchy, b.hierarchy, b_to_a, options, a.build,
                                {app::explained_node(a.hierarchy, a.name, node_a, "node_a"),
                                 app::explained_node(b.hierarchy, b.name, node_b, "node_b")});
}

py::object dict_of(const ExplainedPair& pair) {
    return py::module_::import("json").attr("loads")(
        app::json_text(app::explanation_json(pair), -1));
}

py::dict ends_of_tests(const ExplainedPair& pair) {
    py::dict ends;  // in the order of the tests
    for (const TestAnswer& test : pair.found.tests)
        ends[py::str(std::string(overlap_test_name(test.test)))] =
            std::string(stage_name(test.stage));
    return ends;
}

}  // namespace

void add_explain(py::module_& module) {
    py::class_<OverlapStep>(module, "Step", py::is_final(),
                            "One comparison of an overlap test of two volumes.")
        .def_property_readonly(
            "stage", [](const OverlapStep& s) { return std::string(stage_name(s.stage)); },
            "The stage at which the test ends where this comparison holds.")
        .def_readonly("formula", &OverlapStep::formula, "What is compared, as the paper has it.")
        .def_readonly("line", &OverlapStep::line, "Of the paper's Figure 8; 0: of none.")
        .def_readonly("left", &OverlapStep::left, "The left side.")
        .def_readonly("right", &OverlapStep::right, "The right side.")
        .def_readonly("slack", &OverlapStep::slack,
                      "By how much the comparison holds (positive) or is missed, a length.")
        .def_readonly("separates", &OverlapStep::separates, "Whether the comparison holds.")
        .def_readonly("skipped", &OverlapStep::skipped,
                      R"(Why the test does not make this comparison; "" where it does.)")
        .def_readonly("error", &OverlapStep::error,
                      R"(What is wrong with it, in tests that keep errors of the paper; or "".)")
        .def("__repr__", [](const OverlapStep& s) {
            return "<scb.Step " + std::string(stage_name(s.stage)) + ": " + s.formula + ">";
        });
    py::class_<ExplainedPair>(
        module, "Explanation", py::is_final(),
        "One overlap test of two nodes, step by step, and whether it is right.")
        .def_property_readonly(
            "stage",
            [](const ExplainedPair& p) { return std::string(stage_name(p.found.steps.stage())); },
            R"(How the test ends: "overlapping", or the stage that rejects.)")
        .def_property_readonly(
            "exact",
            [](const ExplainedPair& p) {
                return std::string(contact_names[p.found.certificate.contact]);
            },
            R"(What is true of the volumes: "disjoint", "overlapping" or "touching".)")
        .def_property_readonly(
            "margin", [](const ExplainedPair& p) { return p.found.certificate.margin; },
            "The gap of disjoint volumes, or how deep others are in each other, at least; a "
            "length.")
        .def_property_readonly(
            "answer",
            [](const ExplainedPair& p) { return std::string(answer_names[p.found.answer]); },
            R"("correct", "false positive" or "false negative".)")
        .def_property_readonly("tests", ends_of_tests,
                               "How each of the tests for slab cut balls ends; empty for others.")
        .def_property_readonly(
            "steps", [](const ExplainedPair& p) { return p.found.steps.steps; },
            "The comparisons in the test's order, with those behind the one that decides.")
        .def_property_readonly(
            "decisive", [](const ExplainedPair& p) { return p.found.steps.decisive(); },
            "Which of the steps rejects; None where the test passes.")
        .def("to_dict", dict_of, "All of it, as `scb explain --json` prints it.")
        .def("__str__", [](const ExplainedPair& p) { return app::explanation_text(p, false); })
        .def("__repr__", [](const ExplainedPair& p) {
            return "<scb.Explanation: " + std::string(stage_name(p.found.steps.stage())) + ", " +
                   std::string(answer_names[p.found.answer]) + ">";
        });
    module.def("explain", explain_nodes, py::arg("a"), py::arg("node_a"), py::arg("b"),
               py::arg("node_b"), py::arg("pose") = py::none(), py::kw_only(),
               py::arg("test") = "symmetric", py::arg("threshold") = 0.7,
               R"(Explain the overlap test of a node of a and a node of b, step by step.

pose: 4 x 4 or 3 x 4, from b's frame to a's. str() of the result is for readers.

Raises InputError where there is no such node, and as collide does.)");
}

}  // namespace scb::python
