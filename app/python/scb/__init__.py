"""Bounding volume hierarchies of slab cut balls: build, collide, explain, draw.

Lengths are in the unit of the meshes. Poses are rigid 4 x 4 matrices that act on columns. Triangles
are row numbers of Mesh.triangles, nodes are indices of a hierarchy's arrays. The manual is
app/python/README.md of the project.
"""

import os as _os

from . import _scb
from ._scb import (
    Collision,
    Collisions,
    Explanation,
    Hierarchy,
    Image,
    Mesh,
    Queries,
    QueryFrame,
    Scene,
    Step,
    View,
    Volumes,
    Waste,
    __version__,
    build,
    collide,
    collide_poses,
    draw_level,
    draw_pairs,
    explain,
    load_scene,
    open_queries,
    read_mesh,
    relative_pose,
    scene_names,
    view,
    volume_kinds,
)
from .errors import (
    DrawError,
    Error,
    GlError,
    InputError,
    MeshReaderError,
    OutputError,
    SystemLimitError,
)

_scb._set_mesh_reader(_os.path.join(_os.path.dirname(_os.path.abspath(__file__)), "mesh_reader"))

__all__ = [
    "Collision",
    "Collisions",
    "DrawError",
    "Error",
    "Explanation",
    "GlError",
    "Hierarchy",
    "Image",
    "InputError",
    "Mesh",
    "MeshReaderError",
    "OutputError",
    "Queries",
    "QueryFrame",
    "Scene",
    "Step",
    "SystemLimitError",
    "View",
    "Volumes",
    "Waste",
    "__version__",
    "build",
    "collide",
    "collide_poses",
    "draw_level",
    "draw_pairs",
    "explain",
    "load_scene",
    "open_queries",
    "read_mesh",
    "relative_pose",
    "scene_names",
    "view",
    "volume_kinds",
]
