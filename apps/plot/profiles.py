"""Profiles over the height at a few times, with the reference solution where there is one."""

from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes

import scene as scenes
from picture import METRES_TO_MM, TIME_COLOURS, WIDE, label_above, save
from read_run import Run
from reference_incline import ReferenceProfile, read_reference, variant_of

SHARES_OF_THE_RUN = (0.05, 0.2, 0.4, 0.6, 1)


class Quantity(NamedTuple):
    """A column that is drawn."""

    column: str
    label: str
    scale: float  # from SI to the unit of the label
    reference: str  # member of ReferenceProfile, empty if the table lacks it


MEAN_SIZE = Quantity("grain_size", "mean grain size [mm]", METRES_TO_MM, "mean_size")
VELOCITY = Quantity("velocity", "velocity along the slope [m/s]", 1, "velocity")
PRESSURE = Quantity("pressure", "pressure [kPa]", 1e-3, "")


def draw_profiles(run: Run) -> list[Path]:
    """Draws mean size and velocity, or pressure and velocity where there are no grains."""
    left = MEAN_SIZE if run.has("grain_size") else PRESSURE
    frames = _frames_to_draw(run)
    references = _references_at(run, frames)
    figure, both = plt.subplots(1, 2, figsize=WIDE, sharey=True, layout="constrained")
    colours = time_colours(len(frames))
    for axes, quantity in zip(both, (left, VELOCITY)):
        _draw_quantity(axes, run, quantity, frames, colours)
        _draw_references(axes, references, quantity)
    both[0].set_ylabel("height above the base [m]")
    if left is MEAN_SIZE:
        _show_all_sizes(both[0], run)
    _label_times(both[1], run, frames, colours)
    if references:
        both[0].legend(handles=both[0].lines[-1:], labels=["reference"], loc="upper left", frameon=False)
    return save(figure, run.directory / "profiles")


def time_colours(count: int) -> np.ndarray:
    """One colour for each time, late times light but never too light to read on white."""
    return plt.get_cmap(TIME_COLOURS)(np.linspace(0, 0.85, count))


def _frames_to_draw(run: Run) -> list[int]:
    end = run.times[-1]
    return sorted({run.nearest(share * end) for share in SHARES_OF_THE_RUN})


def _references_at(run: Run, frames: Sequence[int]) -> list[ReferenceProfile]:
    """The reference profiles at the times of these frames."""
    variant = variant_of(run.scene)
    if variant is None:
        return []
    times = run.times[frames]
    return [profile for profile in read_reference(variant) if np.isclose(times, profile.time).any()]


def _draw_quantity(axes: Axes, run: Run, quantity: Quantity, frames: Sequence[int], colours: np.ndarray) -> None:
    for frame, colour in zip(frames, colours):
        profile = run.profile(frame, quantity.column)
        axes.plot(quantity.scale * profile.values, profile.y, color=colour)
    axes.set_xlabel(quantity.label)
    axes.set_ylim(bottom=0)


def _draw_references(axes: Axes, references: Sequence[ReferenceProfile], quantity: Quantity) -> None:
    if not quantity.reference:
        return
    for profile in references:
        values = getattr(profile, quantity.reference)
        axes.plot(values, profile.y, color="black", linewidth=1.2, linestyle=(0, (5, 4)))


def _show_all_sizes(axes: Axes, run: Run) -> None:
    """Widens the axis of the mean size to what the classes allow, so that small changes look small."""
    classes = scenes.diameter_range(run.scene)
    if classes is not None:
        low, high = (METRES_TO_MM * diameter for diameter in classes)
        margin = 0.04 * (high - low)
        axes.set_xlim(low - margin, high + margin)


def _label_times(axes: Axes, run: Run, frames: Sequence[int], colours: np.ndarray) -> None:
    """Names the curves of the velocity by their times, where they reach the surface."""
    axes.set_xlim(left=min(0, axes.get_xlim()[0]))
    profiles = [run.profile(frame, "velocity") for frame in frames]
    surfaces = [np.flatnonzero(np.isfinite(profile.values))[-1] for profile in profiles]
    label_above(
        axes,
        [profile.values[top] for profile, top in zip(profiles, surfaces)],
        [profile.y[top] for profile, top in zip(profiles, surfaces)],
        [f"{run.times[frame]:.3g} s" for frame in frames],
        colours,
    )
