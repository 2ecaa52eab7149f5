"""Arrays that results hand out: no copies, read-only, and alive as long as anybody has them."""

import gc
import resource
import unittest

import numpy as np
import scb
from support import built, moved, plate, tetrahedron


class Arrays(unittest.TestCase):
    def all_arrays(self):
        mesh = plate()
        h = scb.build(mesh, "scb2")
        found = scb.collide(h, h)
        many = scb.collide_poses(h, h, [moved(), moved(z=9)])
        frame = scb.open_queries(scb.Scene({"a": mesh, "b": mesh})).frame(0)
        image = scb.draw_level(scb.Scene({"a": mesh}), 3, size=(400, 320), samples=1)
        yield from (mesh.vertices, mesh.triangles, h.first, h.count, h.left, h.order, h.depths)
        yield from h.volumes.fields.values()
        yield from (found.pairs, many.pairs, many.pairs_of(0), many.n_v, many.stages, many.offsets)
        yield from (frame.node_a, frame.outcome, frame.triangle_b, frame.intersect, frame.pairs, frame.parent)
        yield image.array

    def test_are_read_only_and_outlive_what_they_are_of(self):
        arrays = list(self.all_arrays())
        copies = [array.copy() for array in arrays]
        gc.collect()
        # What was freed would be used again.
        waste = [np.full(array.shape, 77, array.dtype) for array in arrays for _ in range(3)]
        for array, copy in zip(arrays, copies):
            np.testing.assert_array_equal(array, copy)
            self.assertFalse(array.flags.writeable)
            with self.assertRaises(ValueError):
                array[...] = 0
        self.assertEqual(len(waste), 3 * len(arrays))

    def test_of_meshes_and_hierarchies_are_no_copies(self):
        mesh = plate()
        h = scb.build(mesh)
        for once, again in ((mesh.vertices, h.mesh.vertices), (h.volumes.normals, h.volumes.normals),
                            (h.volumes.radii, h.volumes.radii), (h.first, h.first), (h.order, h.order)):
            self.assertTrue(np.shares_memory(once, again))
        scene = scb.load_scene("spheres-l1")
        self.assertTrue(np.shares_memory(scene.mesh("A").vertices, scene.mesh("A").vertices))
        found = scb.collide(h, h)
        self.assertTrue(np.shares_memory(found.pairs, found.pairs))

    def test_given_to_a_mesh_are_copied(self):
        vertices = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0]])
        triangles = np.array([[0, 1, 2]])
        mesh = scb.Mesh(vertices, triangles)
        vertices[:] = np.nan
        triangles[:] = 99
        self.assertEqual(mesh.vertices[1].tolist(), [1, 0, 0])
        self.assertEqual(mesh.triangles.tolist(), [[0, 1, 2]])

    def test_of_all_layouts_are_taken(self):
        want = scb.collide(scb.build(plate()), scb.build(tetrahedron()), moved(0.1, 0.2, -0.5))
        mesh, pose = tetrahedron(), moved(0.1, 0.2, -0.5)
        packed = np.zeros(4, dtype=[("skip", "u1"), ("at", "f8", 3)])  # not aligned
        packed["at"] = mesh.vertices
        for vertices in (np.asfortranarray(mesh.vertices), mesh.vertices.astype(">f8"), packed["at"],
                         mesh.vertices.astype(np.float32), mesh.vertices.astype(np.int8),
                         np.repeat(mesh.vertices, 2, axis=1)[:, ::2], mesh.vertices.tolist()):
            for triangles in (mesh.triangles, mesh.triangles.astype(np.int64), mesh.triangles.astype(np.uint8),
                              np.asfortranarray(mesh.triangles), mesh.triangles.tolist()):
                b = scb.build(scb.Mesh(vertices, triangles))
                found = scb.collide(scb.build(plate()), b, np.asfortranarray(pose))
                np.testing.assert_array_equal(found.pairs, want.pairs)

    def test_have_the_volumes_that_they_say(self):
        h = scb.build(scb.load_scene("spheres-l1").mesh("A"))
        v, vertices = h.volumes, h.mesh.vertices
        for node in (0, 1, 5, 77, len(h) - 1):
            rows = h.order[h.first[node]:h.first[node] + h.count[node]]
            below = vertices[h.mesh.triangles[rows]].reshape(-1, 3) - v.centers[node]
            self.assertLessEqual(np.linalg.norm(below, axis=1).max(), v.radii[node] + 1e-12)
            along = below @ v.normals[node]
            self.assertTrue((along <= v.e[node] + 1e-12).all() and (along >= v.f[node] - 1e-12).all())
        level = h.level(3)
        np.testing.assert_array_equal(level.centers, v.centers[level.nodes])
        np.testing.assert_array_equal(level.e, v.e[level.nodes])
        self.assertTrue((h.depths[level.nodes] == 3).all())
        self.assertEqual(sorted(h.count[h.level("leaves").nodes]), [1] * 20_480)

    def test_have_fields_for_every_volume(self):
        for kind in scb.volume_kinds():
            h = scb.build(plate(), kind)
            for name, array in h.volumes.fields.items():
                self.assertEqual(len(array), len(h), (kind, name))
                self.assertTrue(np.isfinite(array).all(), (kind, name))
            self.assertEqual(h.validate(), "")
        h = scb.build(scb.load_scene("spheres-l1").mesh("A"), "obb")
        box = h.volumes.fields
        for node in range(40):
            rows = h.order[h.first[node]:h.first[node] + h.count[node]]
            below = h.mesh.vertices[h.mesh.triangles[rows]].reshape(-1, 3) - box["centers"][node]
            along = np.abs(below @ box["axes"][node])  # columns are the axes
            self.assertTrue((along <= box["half_lengths"][node] + 1e-12).all())
        with self.assertRaisesRegex(AttributeError, "the kind ball have no normals; they have centers, radii"):
            scb.build(plate(), "ball").volumes.normals

    def test_are_freed(self):
        a, b = scb.build(plate(64)), scb.build(plate(64))

        def use():
            for _ in range(200):
                found = scb.collide(a, b)
                self.assertGreater(len(found.pairs), 10_000)
                scb.Mesh(a.mesh.vertices, a.mesh.triangles).vertices
                a.volumes.fields

        use()
        before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        use()
        self.assertLess(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before, 20_000)  # KiB

    def test_scenes_keep_what_they_are_made_of(self):
        poses = np.stack([moved(z=0.1 * i - 0.5) for i in range(5)])
        mesh = tetrahedron()
        scene = scb.Scene({"plate": plate(), "one": mesh, "two": mesh}, {"one": poses}, name="my scene")
        self.assertEqual((scene.name, scene.bodies, scene.frames), ("my-scene", ["plate", "one", "two"], 5))
        np.testing.assert_array_equal(scene.poses("one"), poses)
        np.testing.assert_array_equal(scene.poses("two", [0, 3]), [np.eye(4)] * 2)
        np.testing.assert_array_equal(scene.relative_poses("one", "plate", [1])[0],
                                      scb.relative_pose(poses[1], np.eye(4)))
        self.assertTrue(np.shares_memory(scene.mesh("one").vertices, scene.mesh("two").vertices))
        found = scb.collide_poses(*built(scene), scene.relative_poses("plate", "one"))
        queries = scb.open_queries(scene, bodies="plate,one")
        self.assertEqual([queries.frame(i).n_v for i in queries.frames], found.n_v.tolist())


if __name__ == "__main__":
    unittest.main()
