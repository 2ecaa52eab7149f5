"""Ten thousand poses in one call: where along a path does a body touch another?"""

import numpy as np
import scb

scene = scb.load_scene("thin-cylinder")
body = scb.build(scene.mesh(scene.bodies[0]), "scb2")

poses = np.tile(np.eye(4), (10_000, 1, 1))
poses[:, 0, 3] = np.linspace(0.0, 5.0, len(poses))
found = scb.collide_poses(body, body, poses)

touches = np.diff(found.offsets) > 0
print(f"{touches.sum()} of {len(found)} poses touch, the last at x = {poses[touches, 0, 3].max():.4f}")
print(f"mean N_v = {found.n_v.mean():.1f}, mean N_p = {found.n_p.mean():.1f}")
