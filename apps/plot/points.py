"""The material points of the last frame, coloured by mean grain size, with the velocity beside them."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import EllipseCollection
from matplotlib.figure import Figure

import scene as scenes
from grain_size import colour_range
from picture import GRAIN_COLOURS, METRES_TO_MM, WIDE, save
from read_run import Run

NARROWEST = 0.8  # [-], width of the picture of the points over their height, below which periods are repeated
WIDEST_SHARE = 2.5  # [-], most that the panel of the points takes, over that of the velocity
MARGINS = 2  # [inch], what labels take of the width and of the height
LOWEST = 5  # [inch], room for the label along the height


def draw_points(run: Run) -> list[Path]:
    """Draws a run in two or three dimensions; of three, the slice one mesh cell thick in the middle."""
    frame = run.num_frames - 1
    x, y, sizes = _middle_slice(run, frame)
    copies = _num_copies(run, float(np.ptp(y)))
    period = run.scene["mesh"]["size"][0]
    x = np.concatenate([x + copy * period for copy in range(copies)])
    figure, (left, right) = _two_panels(float(np.ptp(x) / np.ptp(y)))
    profile = run.profile(frame, "velocity")
    left.plot(profile.values, profile.y, color="black")
    left.set(xlabel="velocity [m/s]", xlim=(min(0, np.nanmin(profile.values)), None))
    left.set_ylabel("height above the base [m]")
    points = _draw_circles(right, x, np.tile(y, copies), scenes.point_spacing(run.scene))
    points.set_array(np.tile(sizes, copies))
    points.set_clim(*colour_range(run, sizes))
    right.set(xlabel="along the slope [m]", aspect="equal", ylim=(0, None))
    right.set_title(_title(run.times[frame], copies, period), loc="left")
    figure.colorbar(points, ax=right, label="mean grain size [mm]", pad=0.02)
    return save(figure, run.directory / "points")


def _two_panels(width_over_height: float) -> tuple[Figure, tuple[Axes, Axes]]:
    """A narrow panel and one for points whose cloud has this shape, in a figure no higher than they need."""
    share = float(np.clip(width_over_height, NARROWEST, WIDEST_SHARE))
    panel_width = share / (1 + share) * (WIDE[0] - MARGINS)
    height = min(WIDE[1], max(LOWEST, panel_width / width_over_height + MARGINS))
    return plt.subplots(
        1,
        2,
        figsize=(WIDE[0], height),
        sharey=True,
        layout="compressed",
        gridspec_kw={"width_ratios": (1, share)},
    )


def _middle_slice(run: Run, frame: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Place along the slope and height [m], and mean size [mm], of the points to draw."""
    position = run.read(frame, "position")
    chosen = np.ones(len(position), dtype=bool)
    if scenes.dimensions(run.scene) == 3:
        half_cell = np.diff(scenes.layer_edges(run.scene)[:2])[0] / 2
        chosen = np.abs(position[:, 2] - run.scene["mesh"]["size"][2] / 2) <= half_cell
    return position[chosen, 0], position[chosen, 1], METRES_TO_MM * run.read(frame, "grain_size")[chosen]


def _num_copies(run: Run, height: float) -> int:
    """How often a period is drawn: more than once only where a narrow scene repeats itself along the slope."""
    if run.scene["boundaries"].get("x") != "periodic":
        return 1
    return max(1, round(NARROWEST * height / run.scene["mesh"]["size"][0]))


def _title(time: float, copies: int, period: float) -> str:
    repeated = f"\nperiod of {period:g} m, drawn {copies} times" if copies > 1 else ""
    return f"after {time:.3g} s{repeated}"


def _draw_circles(axes: Axes, x: np.ndarray, y: np.ndarray, spacing: float) -> EllipseCollection:
    """A circle for each point, as large as the area that the point stands for, whatever the zoom."""
    diameters = np.full(len(x), spacing * np.sqrt(4 / np.pi))
    circles = EllipseCollection(
        diameters,
        diameters,
        np.zeros(len(x)),
        units="xy",
        offsets=np.column_stack([x, y]),
        transOffset=axes.transData,
        cmap=GRAIN_COLOURS,
        linewidths=0,
        rasterized=True,
    )
    axes.add_collection(circles)
    axes.autoscale_view()
    return circles
