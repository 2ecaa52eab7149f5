"""Plot the tests of volumes, N_v, over the frames of a scene, for three kinds of volumes."""

import matplotlib  # type: ignore[import]
import scb

matplotlib.use("Agg")
from matplotlib import pyplot

scene = scb.load_scene("spheres-l1")
frames = range(0, scene.frames, 10)
poses = scene.relative_poses("A", "B", frames)
for kind in ("scb", "ball", "obb"):
    a, b = (scb.build(scene.mesh(name), kind) for name in scene.bodies)
    pyplot.plot(frames, scb.collide_poses(a, b, poses).n_v, label=kind)
pyplot.xlabel("frame")
pyplot.ylabel("$N_v$")
pyplot.legend()
pyplot.savefig("tests.svg")
