"""Contact patches and depths equal the reports of the program."""

import unittest

import numpy as np
import scb
from support import BRACKET, built, moved, plate, run_json, tetrahedron


class Patches(unittest.TestCase):
    def test_are_those_of_the_program(self):
        scene = scb.load_scene(BRACKET)
        frames = [30, 85, 95]
        sides = built(scene)
        expected = run_json("collide", BRACKET, "--patches", "--frames", ",".join(map(str, frames)))["frames"]
        counts = []
        for pose, frame in zip(scene.relative_poses(*scene.bodies, frames), expected):
            found = scb.patches(*sides, pose)
            counts.append(len(found))
            self.assertEqual(len(found), len(frame["patches"]))
            for patch, told in zip(found, frame["patches"]):
                self.assertEqual(len(patch.pairs), told["pairs"])
                np.testing.assert_array_equal(patch.box, [told["box"]["lower"], told["box"]["upper"]])
                for vertex, judged, of_side in ((patch.deepest_a, patch.is_judged_a, told["deepest_a"]),
                                                (patch.deepest_b, patch.is_judged_b, told["deepest_b"])):
                    self.assertEqual(judged, of_side["judged"])
                    self.assertEqual(vertex and vertex.vertex, of_side["vertex"])
                    if vertex:
                        np.testing.assert_array_equal(vertex.at, of_side["at"])
                        self.assertEqual((vertex.signed_distance, vertex.triangle),
                                         (of_side["signed_distance"], of_side["triangle"]))
            pairs = np.concatenate([p.pairs for p in found]) if found else np.zeros((0, 2), np.uint32)
            np.testing.assert_array_equal(pairs[np.lexsort(pairs.T[::-1])], scb.collide(*sides, pose).pairs)
        self.assertGreater(max(counts), 0)

    def test_a_depth_in_an_open_mesh_is_not_judged(self):
        a, b = scb.build(plate()), scb.build(tetrahedron())
        (patch,) = scb.patches(a, b, moved(0.25, 0.25, -0.25))
        self.assertEqual((patch.is_judged_a, patch.is_judged_b), (True, False))
        self.assertIsNone(patch.deepest_b)

    def test_refuses_different_volumes(self):
        with self.assertRaisesRegex(scb.InputError, "different volumes"):
            scb.patches(scb.build(plate()), scb.build(tetrahedron(), "obb"))


if __name__ == "__main__":
    unittest.main()
