"""Prints what calls take: the best of five runs. app/python/README.md has the numbers of one machine."""

import time

import numpy as np
import scb
from support import built


def best(works):
    """Of each; in turn, so that a busy machine slows all of them."""
    times = [[] for _ in works]
    for _ in range(5):
        for work, of_work in zip(works, times):
            start = time.perf_counter()
            work()
            of_work.append(time.perf_counter() - start)
    return [min(of_work) for of_work in times]


def compare(what, a, b, poses):
    loop, one, all_threads = best([lambda: [scb.collide(a, b, pose) for pose in poses],
                                   lambda: scb.collide_poses(a, b, poses, threads=1),
                                   lambda: scb.collide_poses(a, b, poses)])
    print(f"{what}: {len(poses)} calls {loop * 1e3:.1f} ms ({loop / len(poses) * 1e6:.2f} us each), "
          f"one call in one thread {one * 1e3:.1f} ms ({loop / one:.2f} times as fast), "
          f"in all {all_threads * 1e3:.1f} ms ({loop / all_threads:.2f})")


triangle = scb.build(scb.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]))
far = np.eye(4)
far[0, 3] = 9
compare("two triangles, apart", triangle, triangle, np.tile(far, (10_000, 1, 1)))
compare("two triangles, in contact", triangle, triangle, np.tile(np.eye(4), (10_000, 1, 1)))
scene = scb.load_scene("spheres-l1")
poses = scene.relative_poses("A", "B", np.arange(0, 500, 5))
compare("spheres-l1, 2 x 20,480 triangles", *built(scene), np.tile(poses, (100, 1, 1)))
