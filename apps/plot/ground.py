"""The ground of a scene, as heights over its mesh."""

from pathlib import Path
from typing import Any

import numpy as np


def heights(scene: dict[str, Any], directory: Path, x: np.ndarray, z: np.ndarray) -> np.ndarray | None:
    """Heights [m] at places of the mesh; None where there is no ground, or triangles make it."""
    terrain = scene.get("terrain")
    if terrain is None:
        return None
    if terrain["surface"] == "plane":
        return _of_plane(terrain, x, z)
    if terrain["surface"] == "profile":
        places = np.linspace(0, scene["mesh"]["size"][0], len(terrain["heights"]))
        return np.interp(x, places, terrain["heights"])
    if terrain["surface"] == "raster":
        return _of_raster(terrain, directory, x, z)
    return None


def _of_plane(terrain: dict[str, Any], x: np.ndarray, z: np.ndarray) -> np.ndarray:
    point = (*terrain["point"], 0.0)[:3]
    normal = (*terrain["normal"], 0.0)[:3]
    return point[1] - (normal[0] * (x - point[0]) + normal[2] * (z - point[2])) / normal[1]


def _of_raster(terrain: dict[str, Any], directory: Path, x: np.ndarray, z: np.ndarray) -> np.ndarray:
    """Linear along each axis between the centres of the map's cells, and beyond the outermost, as the run has it."""
    header, values = read_esri_ascii(directory / terrain["file"])
    origin = terrain.get("origin", (0, 0))
    half = header["cellsize"] / 2
    first = [
        header[f"{axis}llcenter"] if f"{axis}llcenter" in header else header[f"{axis}llcorner"] + half for axis in "xy"
    ]
    places = [(origin[d] + along - first[d]) / header["cellsize"] for d, along in enumerate((x, z))]
    column, row = (np.clip(np.floor(p), 0, n - 2).astype(int) for p, n in zip(places, values.T.shape))
    right, up = places[0] - column, places[1] - row
    south = (1 - right) * values[row, column] + right * values[row, column + 1]
    north = (1 - right) * values[row + 1, column] + right * values[row + 1, column + 1]
    return (1 - up) * south + up * north - terrain.get("datum", 0)


def read_esri_ascii(file: Path) -> tuple[dict[str, float], np.ndarray]:
    """The header of a map, its keys in lower case, and its values, the southernmost row first."""
    words = file.read_text(encoding="utf-8").split()
    header: dict[str, float] = {}
    while words[2 * len(header)][0].isalpha():
        at = 2 * len(header)
        header[words[at].lower()] = float(words[at + 1])
    values = np.array(words[2 * len(header) :], dtype=float).reshape(int(header["nrows"]), int(header["ncols"]))
    return header, values[::-1]
