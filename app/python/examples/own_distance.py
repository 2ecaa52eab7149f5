"""A check of one's own: how far are two bodies apart? Balls bound it from below, vertices from above."""

import numpy as np
import scb

scene = scb.load_scene("spheres-l1")
a, b = (scb.build(scene.mesh(name)) for name in scene.bodies)
offset = np.array([4.0, 0.0, 0.0])  # of B in A's frame

for level in (2, 5, 8):
    of_a, of_b = a.level(level), b.level(level)
    between = np.linalg.norm(of_a.centers[:, None] - of_b.centers - offset, axis=-1)
    gaps = between - of_a.radii[:, None] - of_b.radii
    i, j = np.unravel_index(gaps.argmin(), gaps.shape)
    some = [h.mesh.triangles[h.order[h.first[n]], 0] for h, n in ((a, of_a.nodes[i]), (b, of_b.nodes[j]))]
    most = np.linalg.norm(a.mesh.vertices[some[0]] - b.mesh.vertices[some[1]] - offset)
    print(f"level {level}: at least {max(0.0, gaps.min()):.3f}, at most {most:.3f}")
