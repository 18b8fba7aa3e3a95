"""The frames of a run, read from its directory."""

import tomllib
from pathlib import Path
from typing import Any, NamedTuple

import h5py
import numpy as np

import scene as scenes


class RunError(Exception):
    """A directory that holds no run, or a run that lacks what a picture needs."""


class Profile(NamedTuple):
    """Averages of one column over layers of the height, weighted by mass; NaN where a layer is empty."""

    y: np.ndarray  # [m], centres of the layers
    values: np.ndarray


class Run:
    """A finished or interrupted run: its scene, and its frames in the order of time."""

    def __init__(self, directory: Path) -> None:
        """Opens a run; raises RunError if there is none, or if it lacks frames."""
        self.directory = directory
        for name in ("run.h5", "scene.toml"):
            if not (directory / name).is_file():
                raise RunError(f"{directory}: not the directory of a run: it has no {name}")
        with (directory / "scene.toml").open("rb") as file:
            self.scene: dict[str, Any] = tomllib.load(file)
        self._frames = h5py.File(directory / "run.h5")["frames"]
        self._names = sorted(self._frames)
        if len(self._names) < 2:
            raise RunError(f"{directory}: holds fewer than two frames: nothing to draw yet")
        try:
            self.times = np.array([self._frames[name].attrs["time"] for name in self._names])  # [s]
        except KeyError as missing:
            raise RunError(f"{directory}: cannot read a frame that run.h5 names: {missing.args[0]}") from missing

    @property
    def num_frames(self) -> int:
        return len(self._names)

    def has(self, column: str) -> bool:
        """Whether the frames hold a column."""
        return column in self._frames[self._names[0]]

    def read(self, frame: int, column: str) -> np.ndarray:
        """A column of frame number `frame`, in SI units; raises RunError if it was not written."""
        try:
            return self._frames[self._names[frame]][column][()]
        except KeyError as missing:
            raise RunError(f"{self.directory}: the frames have no {column}: add it to [output] fields") from missing

    def nearest(self, time: float) -> int:
        """The number of the frame whose time is nearest to `time` [s]."""
        return int(np.argmin(np.abs(self.times - time)))

    def profile(self, frame: int, column: str) -> Profile:
        """Averages over layers one mesh cell high; of a vector, of its component along the flow."""
        values = self.read(frame, column)
        if values.ndim == 2:
            values = values[:, 0]
        edges = scenes.layer_edges(self.scene)
        layer = np.searchsorted(edges, self.read(frame, "position")[:, 1], side="right") - 1
        inside = (layer >= 0) & (layer < len(edges) - 1)
        mass = self.read(frame, "mass")[inside]
        masses, moments = (
            np.bincount(layer[inside], weights, minlength=len(edges) - 1) for weights in (mass, mass * values[inside])
        )
        averages = np.divide(moments, masses, out=np.full_like(moments, np.nan), where=masses > 0)
        return Profile((edges[:-1] + edges[1:]) / 2, averages)
