"""What tests share: the program, the sources, and meshes to begin with."""

import json
import os
import pathlib
import subprocess

import numpy as np
import scb

SOURCE = pathlib.Path(os.environ.get("SCB_SOURCE_DIR", pathlib.Path(__file__).parents[2]))
BRACKET = SOURCE / "scenes/samples/bracket.json"


def run_scb(*arguments):
    """What the program prints."""
    command = [os.environ["SCB_PROGRAM"], "--quiet", *map(str, arguments)]
    return subprocess.run(command, check=True, capture_output=True, cwd=SOURCE).stdout.decode()


def run_json(*arguments):
    return json.loads(run_scb(*arguments, "--json"))


def tetrahedron(name="tetrahedron"):
    return scb.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],
                    [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]], name)


def plate(cells=16):
    """A plate of squares in the plane z = 0, two triangles each, as core/README.md has it."""
    side = cells + 1
    vertices = [[i % side - cells / 2, i // side - cells / 2, 0.0] for i in range(side * side)]
    triangles = []
    for i in range(cells * side):
        if i % side != cells:
            triangles += [[i, i + 1, i + side + 1], [i, i + side + 1, i + side]]
    return scb.Mesh(vertices, triangles, "plate")


def moved(x=0.0, y=0.0, z=0.0):
    pose = np.eye(4)
    pose[:3, 3] = x, y, z
    return pose


def built(scene, volume="scb", **options):
    """Hierarchies of the first two bodies."""
    return [scb.build(scene.mesh(name), volume, **options) for name in scene.bodies[:2]]
