"""What pictures need to know of a scene, as tomllib reads it."""

from typing import Any

import numpy as np


def dimensions(scene: dict[str, Any]) -> int:
    """Dimensions of space, 1 to 3."""
    return scene["mesh"]["dimensions"]


def normal_component(scene: dict[str, Any]) -> int:
    """Which number of a position in the scene is the height: a column lies along the normal of the base."""
    return 0 if dimensions(scene) == 1 else 1


def depth_range(scene: dict[str, Any]) -> tuple[float, float]:
    """Lowest and highest height of the material at the start [m]; of regions and streams, those of the mesh."""
    normal = normal_component(scene)
    if "regions" in scene.get("material", {"regions": []}):
        return 0.0, scene["mesh"]["size"][normal]
    return scene["material"]["low"][normal], scene["material"]["high"][normal]


def layer_edges(scene: dict[str, Any]) -> np.ndarray:
    """Heights of the faces of the mesh cells, from the base to the top of the mesh [m]."""
    mesh = scene["mesh"]
    return np.linspace(0, mesh["size"][normal_component(scene)], mesh["cells"] + 1)


def point_spacing(scene: dict[str, Any]) -> float:
    """Distance of the material points along y at the start [m]."""
    edges = layer_edges(scene)
    source = scene["material"] if "material" in scene else scene["inflow"][0]
    return (edges[1] - edges[0]) / source.get("points_per_cell", 3)


def diameter_range(scene: dict[str, Any]) -> tuple[float, float] | None:
    """Smallest and largest diameter of the size classes [m]; None where the scene does not list several."""
    diameters = scene.get("grains", {}).get("diameters", [])
    return (min(diameters), max(diameters)) if len(set(diameters)) > 1 else None
