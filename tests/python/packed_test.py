"""Packed hierarchies find the pairs of the reference, and answer whether two bodies touch."""

import unittest

import numpy as np
import scb
from support import BRACKET, built, moved, plate, tetrahedron


class Packed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scene = scb.load_scene(BRACKET)
        cls.meshes = [cls.scene.mesh(name) for name in cls.scene.bodies]
        cls.frames = np.arange(0, 100, 7)
        cls.poses = cls.scene.relative_poses(*cls.scene.bodies, cls.frames)
        cls.expected = scb.collide_poses(*built(cls.scene), cls.poses)

    def test_has_the_pairs_of_the_reference(self):
        for layout, volume, leaf in (("quantized8", "scb2", 4), ("float4", "scb", 1), ("indexed2", "scb2", 2)):
            a, b = (scb.pack(mesh, layout, volume=volume, leaf=leaf) for mesh in self.meshes)
            self.assertEqual((a.layout, a.volume, a.leaf, a.mesh.name), (layout, volume, leaf, self.meshes[0].name))
            self.assertGreater(a.nbytes, 18 * len(a.mesh.triangles))
            found = [scb.collide_poses(a, b, self.poses, threads=threads) for threads in (1, 2)]
            for i, pose in enumerate(self.poses):
                with self.subTest(layout=layout, frame=self.frames[i]):
                    once = scb.collide(a, b, pose)
                    np.testing.assert_array_equal(once.pairs, self.expected.pairs_of(i))
                    np.testing.assert_array_equal(scb.collide(a, b, pose, threads=2).pairs, once.pairs)
                    for many in found:
                        np.testing.assert_array_equal(many.pairs_of(i), once.pairs)
                        self.assertEqual((many.n_v[i], many.n_p[i], many.n_exact[i], many.n_after_doubles[i]),
                                         (once.n_v, once.n_p, once.n_exact, once.n_after_doubles))
                        self.assertLessEqual(once.n_after_doubles, once.n_exact)
            self.assertEqual(len(found[0]), len(self.poses))
            self.assertRaises(IndexError, found[0].pairs_of, len(self.poses))

    def test_says_whether_bodies_touch(self):
        a, b = map(scb.pack, self.meshes)
        answers = scb.touches_poses(a, b, self.poses)
        np.testing.assert_array_equal(answers, np.diff(self.expected.offsets) > 0)
        self.assertTrue(answers.any() and not answers.all())
        for i, pose in enumerate(self.poses):
            touch = scb.touches(a, b, pose)
            self.assertEqual(bool(touch), answers[i])
            if touch:
                self.assertIn(list(touch.pair), self.expected.pairs_of(i).tolist())
            else:
                self.assertIsNone(touch.pair)

    def test_tells_crossing_from_touching(self):
        a, b = plate(), tetrahedron()
        for z, crosses in ((0, False), (2.0 ** -40, None), (-2.0 ** -40, True)):
            pose = moved(0.25, 0.25, z)
            pairs = scb.collide(scb.pack(a), scb.pack(b), pose).pairs
            answers = scb.crossing(a, b, pairs, pose)
            self.assertEqual((answers.dtype, answers.shape), (np.dtype(bool), (len(pairs),)))
            if crosses is None:
                self.assertEqual(len(pairs), 0)
            else:
                self.assertEqual(answers.any(), crosses)
        with self.assertRaisesRegex(scb.InputError, "pairs: there is no triangle 99 in "):
            scb.crossing(a, b, [[0, 99]])
        with self.assertRaisesRegex(scb.InputError, "pairs: there is no triangle -1 in "):
            scb.crossing(a, b, [[-1, 0]])
        with self.assertRaisesRegex(scb.InputError, "pairs: it is 3; give an array of n x 2"):
            scb.crossing(a, b, [0, 1, 2])

    def test_touches_at_a_single_point(self):
        a, b = scb.pack(plate()), scb.pack(tetrahedron())
        self.assertTrue(scb.touches(a, b, moved(0.25, 0.25, 0)))
        self.assertFalse(scb.touches(a, b, moved(0.25, 0.25, 2.0 ** -40)))
        ends = scb.touches(a, a)
        self.assertLess(ends.n_p, scb.collide(a, a).n_p / 4)

    def test_refuses_bad_input(self):
        mesh = tetrahedron()
        a, b = scb.pack(mesh), scb.pack(mesh, "float2")
        for call in (lambda: scb.pack(mesh, "float3"), lambda: scb.pack(mesh, leaf=5), lambda: scb.pack(mesh, leaf=0),
                     lambda: scb.pack(mesh, volume="obb"), lambda: scb.collide(a, b), lambda: scb.touches(a, b),
                     lambda: scb.touches(a, a, 2 * np.eye(4)), lambda: scb.touches_poses(a, b, [np.eye(4)]),
                     lambda: scb.pack(scb.Mesh(np.full((3, 3), 2e8), [[0, 1, 2]]))):
            self.assertRaises(scb.InputError, call)
        self.assertRaises(TypeError, scb.collide, a, scb.build(mesh))
        self.assertRaises(TypeError, scb.collide, a, a, test="extents")


if __name__ == "__main__":
    unittest.main()
