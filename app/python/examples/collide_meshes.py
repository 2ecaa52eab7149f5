"""Collide a plate of 16 x 16 squares with a tetrahedron that is pushed through it."""

import numpy as np
import scb

x, y = np.meshgrid(np.arange(17.0) - 8, np.arange(17.0) - 8)
i = (np.arange(16)[:, None] * 17 + np.arange(16)).ravel()
plate = scb.Mesh(np.stack([x, y, 0 * x], axis=-1).reshape(-1, 3),
                 np.concatenate([np.stack([i, i + 1, i + 18], 1), np.stack([i, i + 18, i + 17], 1)]))
tetrahedron = scb.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],
                       [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
a, b = scb.pack(plate), scb.pack(tetrahedron)

pose = np.array([[0, -1, 0, 0.9], [1, 0, 0, 0.2], [0, 0, 1, -0.5], [0, 0, 0, 1]])
found = scb.collide(a, b, pose)
for triangle_a, triangle_b in found.pairs:
    print(f"triangle {triangle_a} of A meets triangle {triangle_b} of B")
print(f"{len(found.pairs)} pairs, N_v = {found.n_v}, N_p = {found.n_p}")
