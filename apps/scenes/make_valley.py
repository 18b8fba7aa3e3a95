#!/usr/bin/python3
"""Writes the synthetic valley of valley_collapse.toml: heights of the ground and depths of the release.

make_valley.py [FOLDER]

A trough of round section descends from a bowl, bends once, and runs out onto a fan. East is down the valley.
"""

import argparse
from pathlib import Path

import numpy as np

CELL = 5.0  # [m]
LENGTH = 200.0  # [m], to the east
WIDTH = 80.0  # [m], to the north
CORNER = (2600.0, 1100.0)  # [m], of the valley on its map, east and north
DATUM = 1500.0  # [m], height on the map that is the mesh's bottom
SLOPE = np.tan(np.radians(28))  # of the upper valley
FAN = np.tan(np.radians(5))  # of the fan
BEND = 110.0  # [m], where the slope turns into the fan
EASE = 20.0  # [m], over which it does
RADIUS = 60.0  # [m], of the trough
SWING = 10.0  # [m], of the bend to the side


def ground(x: np.ndarray, z: np.ndarray) -> np.ndarray:
    """Height [m] of the valley floor with the trough cut into it; its outlet is at 4 m."""
    # The slope goes from one to the other as a logistic curve, whose integral is the softplus.
    turned = np.logaddexp(0, (x - BEND) / EASE) - np.logaddexp(0, (LENGTH - BEND) / EASE)
    floor = 4 + SLOPE * (LENGTH - x) + (SLOPE - FAN) * EASE * turned
    centre = WIDTH / 2 + SWING * np.sin(np.pi * x / LENGTH)
    confined = 1 / (1 + np.exp((x - BEND) / EASE))  # the trough opens onto the fan
    return floor + (0.15 + 0.85 * confined) * (z - centre) ** 2 / (2 * RADIUS)


def release(x: np.ndarray, z: np.ndarray) -> np.ndarray:
    """Depth [m] of a mound at the head of the valley."""
    centre = WIDTH / 2 + SWING * np.sin(np.pi * 35 / LENGTH)
    return 8 - 8 * (((x - 35) / 20) ** 2 + ((z - centre) / 16) ** 2)


def write(file: Path, values: np.ndarray) -> None:
    """ESRI ASCII; rows of `values` from south to north."""
    header = (
        f"ncols {values.shape[1]}\nnrows {values.shape[0]}\nxllcorner {CORNER[0]:g}\nyllcorner {CORNER[1]:g}\n"
        f"cellsize {CELL:g}\nnodata_value -9999"
    )
    np.savetxt(file, values[::-1], fmt="%.3f", header=header, comments="")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path, nargs="?", default=Path(__file__).resolve().parent / "valley")
    folder = parser.parse_args().folder
    folder.mkdir(exist_ok=True)
    east = np.arange(CELL / 2, LENGTH, CELL)
    north = np.arange(CELL / 2, WIDTH, CELL)
    x, z = np.meshgrid(east, north)
    write(folder / "ground.asc", DATUM + ground(x, z))
    depth = release(x, z)
    write(folder / "release.asc", np.where(depth > 0, depth, -9999))


if __name__ == "__main__":
    main()
