"""Where material is at three times, seen from the side and, in three dimensions, from above."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable

import ground
import scene as scenes
from picture import TIME_COLOURS, WIDE, save
from read_run import Run

DEPTH_COLOURS = "YlOrRd"
GROUND_COLOUR = "#8a8a8a"
NUM_CONTOURS = 12
SHARES_OF_TIME = (0.0, 0.4, 1.0)  # of the run, at which it is drawn
PANEL = 0.8  # [-], of the width of the picture that panels take


def draw_flow(run: Run) -> list[Path]:
    """Draws a run in two or three dimensions whose frames hold velocity and mass."""
    is_solid = scenes.dimensions(run.scene) == 3
    frames = [run.nearest(share * run.times[-1]) for share in SHARES_OF_TIME]
    size = run.scene["mesh"]["size"]
    columns = 2 if is_solid else 1
    top = _highest(run, frames)
    heights = [PANEL * WIDE[0] / columns * extent / size[0] for extent in ([size[2], top] if is_solid else [top])]
    figure, axes = plt.subplots(
        len(frames),
        columns,
        squeeze=False,
        sharex=True,
        figsize=(WIDE[0], min(WIDE[1] * 1.3, max(len(frames) * max(heights) + 2, WIDE[1] * 0.8))),
        layout="constrained",
    )
    fastest = max(float(np.max(np.linalg.norm(run.read(frame, "velocity"), axis=1))) for frame in frames)
    for row, frame in zip(axes, frames):
        points = _draw_side(row[-1], run, frame, top, fastest)
        row[0].set_title(f"after {run.times[frame]:.3g} s", loc="left")
        if is_solid:
            depths = _draw_depth(row[0], run, frame, _deepest(run, frames))
    axes[-1][-1].set_xlabel("x [m]")
    figure.colorbar(points, ax=axes[:, -1], label="speed [m/s]", shrink=0.8)
    if is_solid:
        axes[-1][0].set_xlabel("x [m]")
        figure.colorbar(depths, ax=axes[:, 0], label="depth [m]", shrink=0.8)
    return save(figure, run.directory / "flow")


def _highest(run: Run, frames: list[int]) -> float:
    """Upper end of the view from the side [m]: the material and the ground in the middle."""
    x, z = _middle_line(run)
    bed = ground.heights(run.scene, run.directory, x, z)
    material = max(float(run.read(frame, "position")[:, 1].max()) for frame in frames)
    return 1.05 * max(material, 0 if bed is None else float(bed.max()))


def _middle_line(run: Run) -> tuple[np.ndarray, np.ndarray]:
    size = run.scene["mesh"]["size"]
    x = np.linspace(0, size[0], 400)
    return x, np.full_like(x, size[2] / 2 if len(size) == 3 else 0)


def _draw_side(axes: Axes, run: Run, frame: int, top: float, fastest: float) -> ScalarMappable:
    """Points coloured by speed, the fastest in front, above the ground along the middle."""
    position = run.read(frame, "position")
    speed = np.linalg.norm(run.read(frame, "velocity"), axis=1)
    x, z = _middle_line(run)
    bed = ground.heights(run.scene, run.directory, x, z)
    if bed is not None:
        axes.fill_between(x, 0, bed, color=GROUND_COLOUR, linewidth=0, alpha=0.5)
    order = np.argsort(speed)
    points = axes.scatter(
        position[order, 0], position[order, 1], c=speed[order], s=2, linewidths=0, cmap=TIME_COLOURS, rasterized=True
    )
    points.set_clim(0, fastest)
    axes.set(xlim=(0, x[-1]), ylim=(0, top), aspect="equal", ylabel="y [m]")
    return points


def _depth(run: Run, frame: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Edges along x and z [m], and the volume over each square of one cell over its area [m], of z then x."""
    size = run.scene["mesh"]["size"]
    cell = size[1] / run.scene["mesh"]["cells"]
    edges = [np.linspace(0, length, round(length / cell) + 1) for length in (size[0], size[2])]
    position = run.read(frame, "position")
    volume = run.read(frame, "mass") / run.scene["rheology"]["density"]
    volumes = np.histogram2d(position[:, 2], position[:, 0], bins=edges[::-1], weights=volume)[0]
    return edges[0], edges[1], volumes / cell**2


def _deepest(run: Run, frames: list[int]) -> float:
    return max(float(_depth(run, frame)[2].max()) for frame in frames)


def _draw_depth(axes: Axes, run: Run, frame: int, deepest: float) -> ScalarMappable:
    """Depth from above, over contours of the ground."""
    x, z, depth = _depth(run, frame)
    places = np.meshgrid((x[:-1] + x[1:]) / 2, (z[:-1] + z[1:]) / 2)
    bed = ground.heights(run.scene, run.directory, *places)
    if bed is not None:
        axes.contour(*places, bed, NUM_CONTOURS, colors=GROUND_COLOUR, linewidths=0.7)
    shown = axes.pcolormesh(x, z, np.where(depth > 0, depth, np.nan), cmap=DEPTH_COLOURS, rasterized=True)
    shown.set_clim(0, deepest)
    axes.set(aspect="equal", ylabel="z [m]", xlim=(0, x[-1]), ylim=(0, z[-1]))
    return shown
