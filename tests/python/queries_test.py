"""Traces, recordings and explanations: every test of a query, and the verdict on it."""

import json
import os
import pathlib
import tempfile
import unittest

import numpy as np
import scb
from support import BRACKET, SOURCE, built, run_json, run_scb


class Queries(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.trace = pathlib.Path(cls.folder.name) / "bracket-trace.scbrec"
        cls.recording = pathlib.Path(cls.folder.name) / "bracket.scbrec"
        for file, options in ((cls.trace, ()), (cls.recording, ("--records",))):
            run_scb("trace", BRACKET, "--frames", "80:90:5", "--volume", "obb", *options, "-o", file)
        cls.scene = scb.load_scene(BRACKET)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def same(self, frame, other):
        for name in ("node_a", "node_b", "depth_a", "depth_b", "parent", "triangle_a", "triangle_b", "intersect",
                     "pairs", "pose"):
            np.testing.assert_array_equal(getattr(frame, name), getattr(other, name), name)
        self.assertEqual((frame.n_v, frame.n_p, frame.complete), (other.n_v, other.n_p, other.complete))
        self.assertEqual(*([names[i] for i in q.outcome]
                           for q in (frame, other) for names in [q.outcome_names]))

    def test_of_traces_and_recordings_are_those_of_the_scene(self):
        now = scb.open_queries(BRACKET, frames="80:90:5", volume="obb")
        trace, recording = scb.open_queries(self.trace), scb.open_queries(self.recording)
        self.assertEqual([q.frames for q in (now, trace, recording)], [[80, 85, 90]] * 3)
        self.assertEqual([q.bodies for q in (now, trace, recording)], [["bracket", "pin"]] * 3)
        self.assertEqual([q.is_recording for q in (now, trace, recording)], [False, False, True])
        self.assertEqual(now.settings, trace.settings)
        self.assertEqual(now.settings["volume"], "obb")
        for number in (85, 80, 90, 85):  # in any order
            self.same(now.frame(number), trace.frame(number))
            self.same(now.frame(number), recording.frame(number))

    def test_nodes_of_another_engine_have_its_numbers(self):
        def number(node):
            return 10000 - 3 * node

        def numbered(line):
            if "node" in line:
                line.update(node=number(line["node"]), children=[number(child) for child in line["children"]],
                            parent=None if line["parent"] is None else number(line["parent"]))
            if "tests" in line:
                line["tests"] = [test if isinstance(test[0], str) else [test[0], number(test[1]), number(test[2])]
                                 for test in line["tests"]]
            return line

        file, lines, own = (pathlib.Path(self.folder.name) / name for name in ("a.scbrec", "a.jsonl", "own.jsonl"))
        run_scb("trace", "line-8", "--frames", "40", "--records", "-o", file)
        run_scb("convert", file, "-o", lines)
        own.write_text("\n".join(json.dumps(numbered(json.loads(line))) for line in lines.read_text().splitlines()))
        frame, other = (scb.open_queries(path).frame(40) for path in (file, own))
        for nodes in ("node_a", "node_b"):
            np.testing.assert_array_equal(getattr(other, nodes), number(getattr(frame, nodes).astype(int)))
        for same in ("depth_a", "depth_b", "outcome", "parent", "pairs"):
            np.testing.assert_array_equal(getattr(other, same), getattr(frame, same))

    def test_are_those_of_collide(self):
        a, b = built(self.scene, "obb")
        frame = scb.open_queries(self.scene, volume="obb", frames="85").frame(85)
        found = scb.collide(a, b, self.scene.relative_poses(*self.scene.bodies, [85])[0])
        np.testing.assert_array_equal(frame.pairs, found.pairs)
        np.testing.assert_array_equal(frame.pose, self.scene.relative_poses(*self.scene.bodies, [85])[0])
        self.assertEqual((frame.n_v, frame.n_p, frame.n_u, frame.stages),
                         (found.n_v, found.n_p, found.n_u, found.stages))
        self.assertEqual(len(frame.node_a), found.n_v)
        self.assertEqual(len(frame.triangle_a), found.n_p)
        self.assertEqual(np.count_nonzero(frame.intersect), len(found.pairs))
        ended = {name: int(np.count_nonzero(frame.outcome == code)) for code, name in frame.outcome_names.items()}
        self.assertEqual({s: n for s, n in found.stages.items() if n and s != "overlapping"},
                         {s: n for s, n in ended.items() if s in found.stages})
        self.assertEqual(ended["triangles meet"], len(found.pairs))
        np.testing.assert_array_equal(frame.depth_a, a.depths[frame.node_a])
        # The pair that led to a test has the parents of its nodes, or one parent and the same other node.
        parent = frame.parent.astype(np.int64)
        self.assertEqual(parent[0], 0xffffffff)
        self.assertTrue((parent[1:] < np.arange(1, len(parent))).all())
        self.assertTrue((frame.depth_a[1:].astype(int) + frame.depth_b[1:]
                         == frame.depth_a[parent[1:]].astype(int) + frame.depth_b[parent[1:]] + 1).all())

    def test_waste_is_that_of_inspect(self):
        queries = scb.open_queries(BRACKET, frames="85,90")
        for number in (90, 85):
            (told,) = run_json("inspect", BRACKET, "--frame", number)["frames"]
            waste = queries.waste(number)
            self.assertEqual(
                [waste.volume_tests, waste.triangle_tests, waste.wasted_volume_tests, waste.wasted_triangle_tests,
                 waste.wasted_by_tests, waste.wasted_by_fit, waste.wrongly_rejected, waste.missed],
                [told["n_v"], told["n_p"], told["wasted"]["n_v"], told["wasted"]["n_p"],
                 told["wasted_by"]["test"]["n_v"], told["wasted_by"]["fit"]["n_v"], told["wrongly_rejected"],
                 told["missed_pairs"]])

    def test_of_printed_lose_pairs(self):
        waste = scb.open_queries("line-8", test="printed", frames="50").waste(50)
        self.assertEqual((waste.wrongly_rejected, waste.missed), (1, 32))

    def test_of_broken_files_are_refused(self):
        for good in (self.trace, self.recording):
            content = good.read_bytes()
            file = pathlib.Path(self.folder.name) / f"broken{good.suffix}"
            for kept in (0, 5, 40, len(content) // 2, len(content) - 1):
                for flipped in (False, True):
                    damaged = bytearray(content[:kept])
                    if flipped and damaged:
                        damaged[kept // 2] ^= 0xff
                    file.write_bytes(damaged)
                    try:
                        queries = scb.open_queries(file)
                        for number in queries.frames:
                            queries.frame(number)
                    except scb.InputError as error:
                        self.assertIn(file.name, str(error))

    def test_explanations_are_those_of_the_program(self):
        a, b = built(self.scene)
        pose = self.scene.relative_poses(*self.scene.bodies, [85])[0]
        for nodes in ((0, 0), (3, 4), (100, 7)):
            for test in ("symmetric", "corrected", "printed"):
                found = scb.explain(a, nodes[0], b, nodes[1], pose, test=test)
                (told,) = run_json("explain", BRACKET, "--frame", 85, "--pair", "%d,%d" % nodes, "--test", test)
                mine = found.to_dict()
                for key in ("nodes", "stage", "exact", "answer", "answers", "a", "b", "pose", "steps", "certificate"):
                    self.assertEqual(mine[key], told[key], key)
                self.assertEqual((found.tests, found.exact, found.answer), (told["stage"], told["exact"], told["answer"]))
                self.assertEqual([(s.stage, s.formula, s.left, s.right, s.slack, s.separates) for s in found.steps],
                                 [(s["stage"], s["formula"], s["left"], s["right"], s["slack"], s["separates"])
                                  for s in told["steps"]])
                self.assertEqual(found.tests[test], found.stage)
                if found.decisive is not None:
                    self.assertEqual(found.steps[found.decisive].stage, found.stage)
                self.assertIn("A: node %d of bracket" % nodes[0], str(found))

    def test_explanations_are_there_for_every_volume(self):
        pose = self.scene.relative_poses(*self.scene.bodies, [85])[0]
        for kind in scb.volume_kinds():
            a, b = built(self.scene, kind)
            found = scb.explain(a, 5, b, 6, pose)
            self.assertIn(found.exact, ("disjoint", "overlapping", "touching"))
            self.assertEqual(found.stage == "overlapping", found.decisive is None)
            self.assertGreaterEqual(found.margin, 0)

    def test_golden_traces_are_read(self):
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(SOURCE / "golden")  # from where they name their scenes
        for file in sorted(pathlib.Path("baselines").glob("degenerate-*-pairs.scbrec")):
            trace = scb.open_queries(file)
            for number in trace.frames:
                self.assertEqual(len(trace.frame(number).node_a), trace.frame(number).n_v)


if __name__ == "__main__":
    unittest.main()
