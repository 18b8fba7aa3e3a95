"""Mean grain size over height and time."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import scene as scenes
from picture import GRAIN_COLOURS, METRES_TO_MM, WIDE, save
from read_run import Run


def draw_grain_size(run: Run) -> list[Path]:
    """Draws the map of mean size into the directory of the run."""
    y, sizes = _sizes_over_time(run)
    figure, axes = plt.subplots(figsize=WIDE, layout="constrained")
    colours = axes.pcolormesh(run.times, y, sizes, shading="nearest", cmap=GRAIN_COLOURS, rasterized=True)
    colours.set_clim(*colour_range(run, sizes))
    filled = y[np.isfinite(sizes).any(axis=1)]
    half = (y[1] - y[0]) / 2
    axes.set(
        xlabel="time [s]",
        ylabel="height above the base [m]",
        xlim=(run.times[0], run.times[-1]),
        ylim=(filled[0] - half, filled[-1] + half),
    )
    figure.colorbar(colours, label="mean grain size [mm]", pad=0.02)
    return save(figure, run.directory / "grain_size")


def colour_range(run: Run, sizes: np.ndarray) -> tuple[float, float]:
    """The sizes [mm] at the ends of the colours: those of the classes, or else of the grains that are drawn."""
    classes = scenes.diameter_range(run.scene)
    if classes is not None:
        return METRES_TO_MM * classes[0], METRES_TO_MM * classes[1]
    low, high = float(np.nanmin(sizes)), float(np.nanmax(sizes))
    one_size = high - low <= 1e-3 * high
    return (0.9 * low, 1.1 * high) if one_size else (low, high)


def _sizes_over_time(run: Run) -> tuple[np.ndarray, np.ndarray]:
    """Heights of the layers [m], and mean sizes [mm] with one row for each layer and one column for each frame."""
    profiles = [run.profile(frame, "grain_size") for frame in range(run.num_frames)]
    return profiles[0].y, METRES_TO_MM * np.column_stack([profile.values for profile in profiles])
