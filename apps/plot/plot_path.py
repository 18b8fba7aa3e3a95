#!/usr/bin/python3
"""Draws the picture of a path into its directory and prints its files.

Exits with 2 if the directory holds no path.
"""

import argparse
import csv
import sys
from pathlib import Path
from typing import NamedTuple

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes

from picture import TIME_COLOURS, WIDE, save

PA_TO_KPA = 1e-3
MARGIN = 0.08  # [-], of an axis beyond the data
LEAST_RANGE = 0.05  # [-], of the pressure, as a share of itself
SMALL = 0.05  # [-], a shear stress below this share of q is none


class PathError(Exception):
    """A directory that holds no path."""


class Shearing(NamedTuple):
    """What is drawn against what: shear if there is any, else compression along y."""

    strain: np.ndarray  # [-]
    stress: np.ndarray  # [Pa]
    strain_label: str
    stress_label: str


def read_path(directory: Path) -> dict[str, np.ndarray]:
    """The columns of a path by name, without their units."""
    file = directory / "path.csv"
    if not file.is_file():
        raise PathError(f"{directory}: not the directory of a path: it has no path.csv")
    with file.open(newline="") as lines:
        header, *rows = csv.reader(lines)
    names = [column.split(" [")[0] for column in header]
    return dict(zip(names, np.array(rows, dtype=float).T))


def shearing_of(path: dict[str, np.ndarray]) -> Shearing:
    """Shear stress over shear strain, or q over the compression along y where there is no shear stress."""
    q = path["deviatoric_stress"]
    if np.abs(path["stress_xy"]).max() > SMALL * q.max():
        return Shearing(2 * path["strain_xy"], path["stress_xy"], "shear strain [-]", "shear stress [kPa]")
    return Shearing(-path["strain_yy"], q, "compression along y [-]", "q [kPa]")


def draw(directory: Path) -> list[Path]:
    """Draws q over p, stress over strain and the change of volume, a colour per stage."""
    path = read_path(directory)
    shearing = shearing_of(path)
    kpa = PA_TO_KPA
    panels = [
        (kpa * path["pressure"], kpa * path["deviatoric_stress"], "p [kPa]", "q [kPa]"),
        (shearing.strain, kpa * shearing.stress, shearing.strain_label, shearing.stress_label),
        (shearing.strain, path["volumetric_strain"], shearing.strain_label, "change of volume [-]"),
    ]
    figure, axes = plt.subplots(1, len(panels), figsize=WIDE, layout="constrained")
    for one, (x, y, x_label, y_label) in zip(axes, panels):
        draw_stages(one, path["stage"], x, y)
        one.set_xlabel(x_label)
        one.set_ylabel(y_label)
    widen(axes[0], kpa * path["pressure"])
    if path["stage"].max() > 1:
        axes[0].legend(frameon=False, fontsize="x-small")
    return save(figure, directory / "path")


def draw_stages(axes: Axes, stage: np.ndarray, x: np.ndarray, y: np.ndarray) -> None:
    """Each stage from where the one before ended; a ring where the path begins."""
    numbers = np.unique(stage).astype(int)
    for number, colour in zip(numbers, plt.get_cmap(TIME_COLOURS)(np.linspace(0, 0.75, len(numbers)))):
        indices = np.flatnonzero(stage == number)
        indices = np.insert(indices, 0, max(0, indices[0] - 1))
        axes.plot(x[indices], y[indices], color=colour, label=f"stage {number}")
    axes.plot(x[0], y[0], "o", markersize=10, markerfacecolor="white", markeredgecolor="black")
    axes.margins(MARGIN)
    axes.ticklabel_format(scilimits=(-3, 4), useOffset=False)
    axes.locator_params(nbins=4)


def widen(axes: Axes, x: np.ndarray) -> None:
    """Widens the axis of a value that hardly changes, so that small changes look small."""
    low, high = axes.get_xlim()
    least = LEAST_RANGE * np.abs(x).max()
    if high - low < least:
        axes.set_xlim((low + high - least) / 2, (low + high + least) / 2)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("directory", type=Path, help="the directory that a path was written to")
    try:
        paths = draw(parser.parse_args().directory)
    except (PathError, OSError) as error:
        print(f"scree path: {error}", file=sys.stderr)
        return 2
    print("\n".join(map(str, paths)))
    return 0


if __name__ == "__main__":
    sys.exit(main())
