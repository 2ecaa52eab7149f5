"""Distances equal the distances of the program, at one pose and at many."""

import math
import unittest

import numpy as np
import scb
from support import BRACKET, built, moved, run_json, tetrahedron


class Distance(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scene = scb.load_scene(BRACKET)
        cls.frames = np.arange(0, 100, 13)
        cls.poses = cls.scene.relative_poses(*cls.scene.bodies, cls.frames)
        cls.sides = built(cls.scene, "scb2", split="cost")
        cls.expected = run_json("distance", BRACKET, "--frames", "0:99:13")["frames"]

    def test_is_that_of_the_program(self):
        many = scb.distance_poses(*self.sides, self.poses, threads=2)
        self.assertEqual(len(many), len(self.poses))
        for i, (pose, expected) in enumerate(zip(self.poses, self.expected)):
            with self.subTest(frame=self.frames[i]):
                once = scb.distance(*self.sides, pose)
                self.assertEqual(once.distance, expected["distance"])
                self.assertEqual(list(once.triangles), expected["triangles"])
                np.testing.assert_array_equal(once.points, expected["points"])
                self.assertEqual((once.n_v, once.n_p, once.n_u), tuple(expected[k] for k in ("n_v", "n_p", "n_u")))
                self.assertEqual(once.stages, expected["stages"])
                self.assertEqual(many.distance[i], once.distance)
                np.testing.assert_array_equal(many.triangles[i], once.triangles)
                np.testing.assert_array_equal(many.points[i], once.points)
                self.assertEqual((many.n_v[i], many.n_p[i]), (once.n_v, once.n_p))

    def test_does_not_depend_on_order_volume_and_seed(self):
        boxes = built(self.scene, "obb")
        for pose in self.poses[:4]:
            once = scb.distance(*self.sides, pose)
            for other in (scb.distance(*boxes, pose), scb.distance(*self.sides, pose, order="depth-first"),
                          scb.distance(*self.sides, pose, seed=once.triangles)):
                self.assertEqual((other.distance, other.triangles), (once.distance, once.triangles))
        without, seeded = (sum(scb.distance(*self.sides, pose, order="depth-first", seed=seed).n_v
                               for pose, seed in zip(self.poses, seeds))
                           for seeds in ([None] * len(self.poses), [e["triangles"] for e in self.expected]))
        self.assertLess(seeded, without)

    def test_is_the_same_of_packed_hierarchies(self):
        packed = [scb.pack(self.scene.mesh(name)) for name in self.scene.bodies]
        many, expected = scb.distance_poses(*packed, self.poses), scb.distance_poses(*self.sides, self.poses)
        np.testing.assert_array_equal(many.distance, expected.distance)
        for i, pose in enumerate(self.poses):
            once = scb.distance(*packed, pose)
            self.assertEqual((once.distance, once.n_v, once.n_p), (many.distance[i], many.n_v[i], many.n_p[i]))
            self.assertEqual((once.n_u, once.stages), (None, None))
            if once.distance > 0:
                self.assertEqual(list(once.triangles), self.expected[i]["triangles"])
                np.testing.assert_array_equal(once.points, expected.points[i])
            np.testing.assert_array_equal(scb.within(*packed, 0.5, pose), scb.within(*self.sides, 0.5, pose))

    def test_has_limits(self):
        a = b = scb.build(tetrahedron())
        apart = scb.distance(a, b, moved(3), limit=1.5)
        self.assertEqual((apart.distance, apart.triangles, apart.points), (math.inf, None, None))
        self.assertEqual(scb.distance(a, b, moved(3)).distance, 2)
        rough = scb.distance_poses(a, b, np.stack([moved(3), moved(1.5)]), limit=1.5)
        np.testing.assert_array_equal(rough.distance, [math.inf, 0.5])
        np.testing.assert_array_equal(rough.triangles[0], [-1, -1])
        self.assertTrue(np.isnan(rough.points[0]).all())

    def test_finds_triangles_within_a_tolerance(self):
        near = scb.within(*self.sides, 0.5, self.poses[4])
        self.assertEqual(len(near), run_json("distance", BRACKET, "--frames", "52", "--within", "0.5")["frames"][0]["pairs"])
        self.assertIn(self.expected[4]["triangles"], near.tolist())
        self.assertEqual(len(scb.within(*self.sides, 0.1, self.poses[4])), 0)

    def test_refuses_what_has_no_meaning(self):
        a = b = scb.build(tetrahedron())
        for call in (lambda: scb.distance(a, b, order="best"), lambda: scb.distance(a, b, limit=-1),
                     lambda: scb.distance(a, b, relative_error=math.nan), lambda: scb.distance(a, b, seed=[0, 4]),
                     lambda: scb.distance(a, scb.build(tetrahedron(), "obb")), lambda: scb.within(a, b, -1),
                     lambda: scb.distance(a, b, 2 * np.eye(4)), lambda: scb.within(a, b, math.inf)):
            self.assertRaises(scb.InputError, call)


if __name__ == "__main__":
    unittest.main()
