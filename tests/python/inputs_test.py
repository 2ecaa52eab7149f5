"""Every wrong input leads to an exception with a message, and never to a crash."""

import copy
import json
import os
import pickle
import tempfile
import unittest
import warnings

import numpy as np
import scb
from support import BRACKET, moved, plate, tetrahedron

TRIANGLE = [[0.0, 0, 0], [1, 0, 0], [0, 1, 0]]


class Inputs(unittest.TestCase):
    def refuses(self, words, function, *arguments, error=scb.InputError, **options):
        with self.subTest(words=words), self.assertRaisesRegex(error, words) as caught:
            function(*arguments, **options)
        if error is scb.InputError:
            self.assertIsInstance(caught.exception, (ValueError, scb.Error))
            self.assertTrue(str(caught.exception).endswith("."), str(caught.exception))
            self.assertNotIn("\n", str(caught.exception))

    def test_meshes(self):
        for vertices, triangles, words in (
            ([], [[0, 1, 2]], "vertices: it is 0; give an array of n x 3 numbers"),
            (np.zeros((0, 3)), [[0, 1, 2]], "triangle 0 names vertex 0"),
            (TRIANGLE, [], "triangles: its elements are float64; give an array of m x 3 whole numbers"),
            (TRIANGLE, np.zeros((0, 3), int), "the mesh has no triangles"),
            (TRIANGLE, [0, 1, 2], "triangles: it is 3; give"),
            (TRIANGLE, [[0, 1, 2, 0]], "triangles: it is 1 x 4; give"),
            (TRIANGLE, [[0, 1, 3]], "triangle 0 names vertex 3"),
            (TRIANGLE, [[0, 1, -1]], "triangle 0 names vertex -1"),
            (TRIANGLE, np.array([[0, 1, 2**63]], np.uint64), "triangle 0 names vertex -9"),
            (TRIANGLE, [[0, 1, 2**32]], "triangle 0 names vertex 4294967296"),
            (TRIANGLE, [[0, 1, 2**70]], "its elements are object"),
            (TRIANGLE, [[0.0, 1.0, 2.0]], "its elements are float64"),
            (TRIANGLE, [[True, False, True]], "its elements are bool"),
            (TRIANGLE, None, "its elements are object"),
            (None, [[0, 1, 2]], "its elements are object"),
            ("abc", [[0, 1, 2]], "its elements are <U3"),
            ([[0, 0, 0], [1, 0]], [[0, 1, 2]], "vertices: "),
            (np.zeros((3, 2)), [[0, 1, 2]], "vertices: it is 3 x 2; give"),
            (np.zeros((3, 3, 1)), [[0, 1, 2]], "vertices: it is 3 x 3 x 1; give"),
            (np.zeros((3, 3), complex), [[0, 1, 2]], "its elements are complex128"),
            (np.array(TRIANGLE) * np.nan, [[0, 1, 2]], "vertex 0 of triangle 0 has the coordinate"),
            (np.full((3, 3), np.inf), [[0, 1, 2]], "coordinates must be finite"),
            (np.array(TRIANGLE) * 1e71, [[0, 1, 2]], "at most 1e\\+70"),
            (np.zeros((3, 3), "m8[s]"), [[0, 1, 2]], "its elements are timedelta64"),
        ):
            self.refuses(words, scb.Mesh, vertices, triangles, "my mesh")
        self.refuses("incompatible", scb.Mesh, error=TypeError)
        self.refuses("mesh 'x'|^x: ", scb.Mesh, TRIANGLE, [[9, 9, 9]], "x")

    def test_degenerate_meshes_are_legal(self):
        for vertices, triangles in ((TRIANGLE, [[0, 0, 0]]), (TRIANGLE, [[0, 1, 2]] * 5),
                                    ([[1e-300, 0, 0]] * 3, [[0, 1, 2]]), (TRIANGLE + [[np.nan] * 3], [[0, 1, 2]])):
            for kind in scb.volume_kinds():
                h = scb.build(scb.Mesh(vertices, triangles), kind)
                self.assertEqual(h.validate(), "")
                scb.collide(h, h)

    def test_poses(self):
        h = scb.build(plate())
        mirrored, sheared, far = np.diag([1.0, 1, -1, 1]), np.eye(4), moved(x=1e71)
        sheared[0, 1] = 2e-3
        last = np.eye(4)
        last[3] = 0, 0, 1, 1
        for pose, words in (
            (np.eye(3), "pose: it is 3 x 3; give"), (np.zeros((3, 4)), "not rigid"), (np.zeros((2, 4)), "2 x 4; give 4 x 4 or 3 x 4"),
            (np.eye(4) * np.nan, "pose: "), (moved(x=np.nan), "pose: .* not finite"),
            (moved(x=np.inf), "not finite"), (far, "beyond 1e70"), (mirrored, "it mirrors"),
            (sheared, "differs from the identity by 0.002, 1e-3 is allowed"), (np.diag([2.0, 2, 2, 1]), "not rigid"),
            (np.zeros((4, 4)), "the last row"), (last, "the last row of the matrix is not 0 0 0 1"),
            (np.eye(4, dtype=complex), "complex"), ("pose", "its elements"), ([], "it is 0; give"),
        ):
            self.refuses(words, scb.collide, h, h, pose)
            self.refuses("poses|pose", scb.collide_poses, h, h, [np.eye(4), pose] if np.shape(pose) == (4, 4) else pose)
        self.refuses(r"poses\[1\]: .*mirrors", scb.collide_poses, h, h, [np.eye(4), mirrored])
        self.refuses("poses: it is 4 x 4; give an array of n x 4 x 4", scb.collide_poses, h, h, np.eye(4))
        self.refuses("n x 4 x 4", scb.collide_poses, h, h, np.zeros((2, 2, 4)))
        self.refuses("^b: .*mirrors", scb.relative_pose, np.eye(4), mirrored)
        self.assertEqual(len(scb.collide_poses(h, h, np.zeros((0, 4, 4)))), 0)

    def test_poses_of_few_digits(self):
        h = scb.build(plate())
        angle = np.radians(33)
        exact = moved(x=0.1)
        exact[:2, :2] = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
        with warnings.catch_warnings(record=True) as none:
            warnings.simplefilter("always")
            expected = scb.collide(h, h, exact)
            rows = scb.collide(h, h, exact[:3])
        self.assertEqual(none, [])
        np.testing.assert_array_equal(rows.pairs, expected.pairs)
        with warnings.catch_warnings(record=True) as one:
            warnings.simplefilter("always")
            found = scb.collide_poses(h, h, np.array([exact[:3]] * 3, dtype=np.float32))
        self.assertEqual(len(one), 1)
        self.assertRegex(str(one[0].message), "^poses: not quite a rotation; the nearest one is used.")
        self.assertEqual([len(found.pairs_of(i)) for i in range(3)], [len(expected.pairs)] * 3)

    def test_a_pose_of_few_digits_in_a_scene_file(self):
        body = {"name": "A", "model": "m"}
        rough = dict(body, name="B", pose=[0.866025, -0.5, 0, 1, 0.5, 0.866025, 0, 0, 0, 0, 1, 0])
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "s.json")
            with open(path, "w") as file:
                json.dump({"scb_scene": 1, "name": "s", "models": [{"name": "m", "box": {}}], "bodies": [body, rough]}, file)
            with self.assertWarnsRegex(UserWarning, "^the pose of B: not quite a rotation"):
                scb.load_scene(path)
            self.refuses("1e-9", scb.load_scene, path, exact_pose=True)
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                with self.assertRaises(UserWarning):
                    scb.load_scene(path)

    def test_options_of_hierarchies(self):
        for options, words in (
            (dict(volume="cube"), "'cube' is not a volume; give some of scb,ball"),
            (dict(volume=""), "'' is not a volume"), (dict(volume="scb,obb"), "one of .* at a time"),
            (dict(split="x"), "'x' is not a way to divide nodes"), (dict(split="paper,cost"), "give one"),
            (dict(growth="x"), "--growth x: give ritter or radius"),
            (dict(margin=-1), "--margin -1"), (dict(margin=np.nan), "--margin nan"),
            (dict(threads=-1), "threads: give 0"),
        ):
            self.refuses(words, scb.build, plate(), **options)
        for options in (dict(margin="x"), dict(threads=1.5), dict(threads=2**70), dict(volume=3), dict(nothing=1)):
            self.refuses("incompatible", scb.build, plate(), error=TypeError, **options)

    def test_options_of_queries(self):
        h, other = scb.build(plate()), scb.build(plate(), "obb")
        self.refuses("scb and obb; build both of one kind", scb.collide, h, other)
        for options, words in (
            (dict(test="x"), "'x' is not an overlap test"), (dict(threshold=2), "--threshold 2"),
            (dict(threshold=np.nan), "--threshold nan"), (dict(descent="x"), "--descent x: give one of radius"),
            (dict(max_pairs=0), "--max-pairs 0: give at least 1"), (dict(max_pairs=-5), "give at least 1"),
            (dict(stop_level=-1), "levels -1"), (dict(stop_level=999), "levels 999"),
        ):
            self.refuses(words, scb.collide, h, h, **options)
            self.refuses(words, scb.collide_poses, h, h, [np.eye(4)], **options)
        self.refuses("incompatible", scb.collide, h, h, error=TypeError, max_pairs=2**64)
        self.refuses("incompatible", scb.collide, h, None, error=TypeError)

    def test_levels_and_nodes(self):
        h = scb.build(plate())
        for level in (-1, h.depth + 1, 2**40):
            self.refuses(f"level {level}: ", h.level, level)
        for level in ("x", "", "1,2", "all", 1.5, None, [1]):
            self.refuses("level", h.level, level)
        self.refuses("", h.level, 2**80, error=OverflowError)
        self.assertEqual(len(h.level(np.int8(2))), 4)
        for node in (-1, len(h), 2**40):
            self.refuses(f"node_a: there is no node {node} of plate", scb.explain, h, node, h, 0)
            self.refuses("node_b: there is no node", scb.explain, h, 0, h, node)
        small = scb.build(tetrahedron())
        self.refuses("node_b: there is no node 7 of tetrahedron", scb.explain, h, 7, small, 7)
        self.refuses("node_a: there is no node 7 of tetrahedron", scb.explain, small, 7, h, 7)
        self.refuses("pose: it is 3 x 3", scb.explain, h, 0, h, 0, np.eye(3))
        found = scb.collide_poses(h, h, [np.eye(4)])
        for index in (1, -2, 2**40):
            self.refuses("there is no pose", found.pairs_of, index, error=IndexError)

    def test_scenes(self):
        mesh, mirrored = tetrahedron(), np.diag([1.0, 1, -1, 1])
        self.refuses("give one body or more", scb.Scene, {})
        self.refuses("give meshes", scb.Scene, {"a": 3}, error=TypeError)
        self.refuses("give meshes", scb.Scene, {3: mesh}, error=TypeError)
        self.refuses("poses\\['b'\\]: there is no such body", scb.Scene, {"a": mesh}, {"b": np.eye(4)})
        self.refuses("poses\\['a'\\].*mirrors", scb.Scene, {"a": mesh}, {"a": mirrored})
        self.refuses("poses\\['a'\\]\\[1\\].*mirrors", scb.Scene, {"a": mesh}, {"a": [np.eye(4), mirrored]})
        self.refuses("give 1 to 1,000,000 poses", scb.Scene, {"a": mesh}, {"a": np.zeros((0, 4, 4))})
        self.refuses("poses\\['a'\\]: ", scb.Scene, {"a": mesh}, {"a": "x"})
        self.refuses("as many, or one", scb.Scene, {"a": mesh, "b": mesh},
                     {"a": [np.eye(4)] * 2, "b": [np.eye(4)] * 3})
        scene = scb.Scene({"a": mesh, "b": mesh})
        self.refuses("'c': is not a body of the scene 'scene'; it has a, b", scene.mesh, "c")
        self.refuses("frame 1: the scene", scene.poses, "a", [0, 1])
        self.refuses("frame -1: the scene", scene.poses, "a", [-1])
        self.refuses("frames: its elements are float64", scene.poses, "a", [0.5])
        self.assertEqual(scene.poses("a", np.zeros(0, int)).shape, (0, 4, 4))
        self.refuses("there is no such scene or file", scb.load_scene, "nowhere")
        self.refuses("did you mean spheres-l1", scb.load_scene, "spheres-l3")
        self.refuses("give one scene, or two files", scb.load_scene)
        self.refuses("give one scene, or two files", scb.load_scene, "a", "b", "c")
        self.refuses("", scb.load_scene, "a\0b", error=ValueError)
        self.refuses("", scb.load_scene, 3, error=TypeError)
        self.refuses("pose", scb.load_scene, "spheres-l1", pose=np.eye(4))

    def test_files(self):
        self.refuses("there is no such file", scb.read_mesh, "/nowhere.ply")
        self.refuses(".", scb.read_mesh, BRACKET)
        self.refuses("", scb.read_mesh, None, error=TypeError)
        self.refuses("there is no such", scb.open_queries, "/nowhere.scbtrace")
        self.refuses("a collision needs two", scb.open_queries, scb.Scene({"a": plate()}))
        self.refuses("name two of them", scb.open_queries, scb.Scene({x: plate() for x in "abc"}))
        self.refuses("is not a body", scb.open_queries, BRACKET, bodies="a,b")
        self.refuses("--frames x", scb.open_queries, BRACKET, frames="x")
        queries = scb.open_queries(BRACKET, frames="3,7")
        for frame in (-1, 4, 2**40):
            self.refuses("there is no query of it; there are queries of 3, 7", queries.frame, frame)
            self.refuses("there is no query of it", queries.waste, frame)

    def test_pictures(self):
        for options, words in (
            (dict(size=(0, 0)), "--size 0x0"), (dict(size=(-5, 400)), "--size -5x400"),
            (dict(size=(10**6, 10**6)), "--size"), (dict(samples=3), "--samples"), (dict(background="red"), "--background red"),
            (dict(camera="x"), "--camera"), (dict(up="w"), "--up"), (dict(gl="metal"), "--gl metal"),
            (dict(frame=500), "500"), (dict(frame=-1), "-1"), (dict(volume="x"), "not a volume"),
        ):
            self.refuses(words, scb.draw_level, "spheres-l1", 2, **options)
            self.refuses(words, scb.draw_pairs, "spheres-l1", **{"frame": 0, **options})
        for level in (-1, 99, "x", 1.5, None, "1,2", "all"):
            self.refuses("level", scb.draw_level, "spheres-l1", level)
        self.refuses("--color-by x: give one of body", scb.draw_level, "spheres-l1", 2, color_by="x")
        self.refuses("--opacity", scb.draw_level, "spheres-l1", 2, opacity=np.nan)
        self.refuses("--steps -1", scb.view, "spheres-l1", steps=-1)
        self.refuses("--compare", scb.view, "spheres-l1", compare="x,y")
        self.refuses("--queries", scb.view, "spheres-l1", queries="x")
        image = scb.draw_level("spheres-l1", 0, size=(400, 320), samples=1)
        self.refuses("/dev/null/", image.save, "/dev/null/x.png", error=scb.OutputError)
        self.assertTrue(issubclass(scb.OutputError, OSError))
        self.assertTrue(issubclass(scb.GlError, RuntimeError))

    def test_classes_without_a_constructor(self):
        for name in ("Hierarchy", "Volumes", "Collision", "Collisions", "Step", "Explanation", "Queries",
                     "QueryFrame", "Waste", "Image", "View"):
            with self.assertRaises(TypeError):
                getattr(scb, name)()
        # An object that was not made by its constructor is refused, too.
        for make in (scb.Mesh.__new__, object.__new__):
            with self.assertRaisesRegex(TypeError, "not safe"):
                make(scb.Mesh)
        for function in (copy.copy, copy.deepcopy, pickle.dumps):
            with self.assertRaisesRegex(TypeError, "cannot pickle"):
                function(plate())
        with self.assertRaises(TypeError):
            type("Mine", (scb.Mesh,), {})
        mesh = plate()
        vertices = mesh.vertices
        mesh.__init__(TRIANGLE, [[0, 1, 2]])  # does nothing
        self.assertEqual((len(vertices), len(mesh.vertices)), (289, 289))


if __name__ == "__main__":
    unittest.main()
