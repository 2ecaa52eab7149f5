"""Counts and pairs equal the program's and the golden suite's, for every volume and number of threads."""

import json
import unittest

import numpy as np
import scb
from support import BRACKET, SOURCE, built, plate, run_json, run_scb, tetrahedron


class Counts(unittest.TestCase):
    def test_are_those_of_the_program_of_the_manual_of_core(self):
        pose = [[0, -1, 0, 0.9], [1, 0, 0, 0.2], [0, 0, 1, -0.5], [0, 0, 0, 1]]
        a, b = scb.build(plate()), scb.build(tetrahedron())
        found = scb.collide(a, b, pose)
        self.assertEqual(found.pairs.tolist(), [[272, 1], [272, 2], [272, 3]])
        self.assertEqual((found.n_v, found.n_p), (115, 30))
        self.assertEqual(scb.collide(a, b, pose, test="extents").n_v, 111)
        expected = dict(scb=115, ball=173, ritter=205, obb=73, scb2=103, aabb=87, dop14=25, dop18=31,
                        dop26=25, rss=71, capsule=159)
        for kind in scb.volume_kinds():
            a, b = scb.build(plate(), kind), scb.build(tetrahedron(), kind)
            self.assertEqual(scb.collide(a, b, pose).n_v, expected.get(kind, 87), kind)

    def compare(self, volume, split, program_frames, arguments, options):
        scene = scb.load_scene(BRACKET)
        a, b = built(scene, volume, split=split)
        poses = scene.relative_poses(*scene.bodies, program_frames)
        found = scb.collide_poses(a, b, poses, **options)
        listed = ",".join(map(str, program_frames))
        told = run_json("collide", BRACKET, "--frames", listed, "--volume", volume, "--split", split,
                        *arguments)
        for i, frame in enumerate(told["frames"]):
            alone = scb.collide(a, b, poses[i], **options)
            with self.subTest(volume=volume, split=split, frame=frame["frame"], **options):
                self.assertEqual(
                    [alone.n_v, alone.n_p, alone.n_u, alone.depth, alone.complete, alone.stages,
                     len(alone.pairs)],
                    [frame[key] for key in ("n_v", "n_p", "n_u", "depth", "complete", "stages", "pairs")])
                self.assertEqual(
                    [found.n_v[i], found.n_p[i], found.n_u[i], found.depth[i], found.complete[i],
                     dict(zip(found.stage_names, found.stages[i].tolist()))],
                    [alone.n_v, alone.n_p, alone.n_u, alone.depth, alone.complete, alone.stages])
                np.testing.assert_array_equal(found.pairs_of(i), alone.pairs)

    def test_are_those_of_the_program_for_every_volume(self):
        for volume in scb.volume_kinds():
            self.compare(volume, "paper", [0, 85, 90], [], {})

    def test_are_those_of_the_program_for_every_option(self):
        for test in ("printed", "line8", "corrected", "symmetric", "extents"):
            self.compare("scb", "paper", [85], ["--test", test, "--threshold", 0.5],
                         dict(test=test, threshold=0.5))
        for descent in ("radius", "area", "volume", "alternating"):
            self.compare("scb2", "cost", [85], ["--descent", descent], dict(descent=descent))
        self.compare("obb", "paper", [85, 90], ["--max-pairs", 7], dict(max_pairs=7))
        self.compare("ball", "paper", [85], ["--levels", 4], dict(stop_level=4))

    def test_pairs_are_those_of_the_program(self):
        scene = scb.load_scene(BRACKET)
        a, b = built(scene)
        pairs = scb.collide(a, b, scene.relative_poses(*scene.bodies, [85])[0]).pairs
        lines = run_scb("collide", BRACKET, "--frames", 85, "--pairs-out", "/dev/stdout").splitlines()
        told = [line.split(",")[1:] for line in lines if line.startswith("85,") and line.count(",") == 2]
        self.assertEqual(pairs.tolist(), [[int(i) for i in pair] for pair in told])

    def test_are_golden(self):
        scene = scb.load_scene("spheres-l1")
        frames = np.arange(0, 500, 10)
        for volume in ("scb", "ball", "obb", "scb2"):
            golden = json.loads(
                (SOURCE / f"golden/baselines/table-3-spheres-l1-{volume}.counts.json").read_text())
            found = scb.collide_poses(*built(scene, volume), scene.relative_poses("A", "B", frames))
            for i, frame in enumerate(frames):
                told = golden["frames"][str(frame)]
                self.assertEqual(
                    [found.n_v[i], found.n_p[i], found.n_u[i], len(found.pairs_of(i)),
                     dict(zip(found.stage_names, found.stages[i].tolist()))],
                    [told[key] for key in ("n_v", "n_p", "n_u", "pairs", "stages")])

    def test_are_near_those_of_an_independent_prototype(self):
        # Means over all frames; its balls grow by the radius alone, and it has line 8 corrected.
        for name, ball, slab_cut, pairs in (("spheres-l1", 96_467, 20_627, 536.9), ("knots-l1", 39_471, 14_795, 0)):
            scene = scb.load_scene(name)
            poses = scene.relative_poses(*scene.bodies)
            for volume, expected in (("ball", ball), ("scb", slab_cut)):
                found = scb.collide_poses(*built(scene, volume, growth="radius"), poses, test="line8")
                self.assertAlmostEqual(found.n_v.mean() / expected, 1, delta=1e-3)
                self.assertAlmostEqual(len(found.pairs) / len(found), pairs, delta=0.05)

    def test_are_the_same_in_any_number_of_threads(self):
        scene = scb.load_scene("spheres-l1")
        poses = scene.relative_poses("A", "B", np.arange(0, 500, 25))
        one = scb.collide_poses(*built(scene, threads=1), poses, threads=1)
        for threads in (2, 3, 64, 0):
            many = scb.collide_poses(*built(scene, threads=threads), poses, threads=threads)
            for name in ("n_v", "n_p", "n_u", "depth", "complete", "stages", "pairs", "offsets"):
                np.testing.assert_array_equal(getattr(one, name), getattr(many, name))


if __name__ == "__main__":
    unittest.main()
