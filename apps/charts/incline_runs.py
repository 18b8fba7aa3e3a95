"""Runs of the inclined-plane flow over ways to discretise it, and their errors and costs."""

import csv
import io
import os
import resource
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

PLOT = Path(__file__).resolve().parents[1] / "plot"
SCENES = Path(__file__).resolve().parents[1] / "scenes"
sys.path.append(str(PLOT))  # the reference profiles are kept beside the pictures that show them

from reference_incline import read_reference  # noqa: E402

REFERENCE_CELLS = 50  # parts of the depth in the reference table
COLUMNS = {"A": "inclined_plane_column_a", "B": "inclined_plane_column", "D": "inclined_plane_column_d"}
PLANE = "inclined_plane"  # variant B in two dimensions


@dataclass(frozen=True)
class Case:
    """One way to discretise one variant of the flow."""

    variant: str  # "A", "B" or "D", as in the reference table
    dimensions: int  # of space: 1 or 2
    shape: str
    transfer: str
    control_volumes: str
    cells: int  # along y

    @property
    def scene(self) -> Path:
        return SCENES / f"{COLUMNS[self.variant] if self.dimensions == 1 else PLANE}.toml"

    @property
    def name(self) -> str:
        parts = (self.variant, f"{self.dimensions}d", self.shape, self.transfer, self.control_volumes, self.cells)
        return "-".join(map(str, parts))


@dataclass(frozen=True)
class Result:
    """What a case costs and how far it is from the reference; NaN where the run did not reach its end."""

    case: Case
    size_error: float  # [mm], mean of |s_a - reference| over the depth and the times of the table
    velocity_error: float  # [m/s], greatest |u - reference| over both
    cpu_seconds: float


def run_case(scree: Path, case: Case, directory: Path, cpu_limit: int) -> Result:
    """Runs one case on one thread, for at most `cpu_limit` seconds, and compares it with the reference."""
    settings = {
        "mesh.cells": case.cells,
        "numerics.shape": case.shape,
        "numerics.transfer": case.transfer,
        "segregation.control_volumes": case.control_volumes,
    }
    command = [str(scree), "run", str(case.scene), "--threads", "1", "--quiet", "--output", str(directory)]
    for key, value in settings.items():
        command += ["--set", f"{key}={value}"]
    limits = (cpu_limit, cpu_limit)
    process = subprocess.Popen(command, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, limits))
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    finished = process.returncode == 0
    size_error, velocity_error = errors_of(scree, case, directory) if finished else (np.nan, np.nan)
    return Result(case, size_error, velocity_error, usage.ru_utime + usage.ru_stime)


def errors_of(scree: Path, case: Case, directory: Path) -> tuple[float, float]:
    """Mean error of the mean size [mm] and greatest error of the velocity [m/s] of a finished run."""
    size_errors, velocity_errors = [], []
    for reference in read_reference(case.variant):
        profile = read_profile(scree, directory, reference.time)
        if not np.allclose(profile["y"], reference.y):
            raise ValueError(f"{directory}: the profile at {reference.time:g} s has other heights than the reference")
        size_errors.append(np.abs(1e3 * profile["mean_grain_size"] - reference.mean_size))
        velocity_errors.append(np.abs(profile["velocity"] - reference.velocity))
    return float(np.mean(size_errors)), float(np.max(velocity_errors))


def read_profile(scree: Path, directory: Path, time: float) -> dict[str, np.ndarray]:
    """The columns that `scree profile` prints, in SI units, from the base up."""
    command = [str(scree), "profile", str(directory), "--time", str(time), "--cells", str(REFERENCE_CELLS)]
    text = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    rows = list(csv.DictReader(io.StringIO(text)))
    return {name: np.array([float(row[name]) for row in rows]) for name in rows[0]}


FIELDS = ["variant", "dimensions", "shape", "transfer", "control_volumes", "cells"]


def write_results(results: Sequence[Result], path: Path) -> None:
    """One line for each run, with units in the names of the columns."""
    with path.open("w", newline="", encoding="utf-8") as table:
        writer = csv.writer(table, lineterminator="\n")
        writer.writerow([*FIELDS, "size_error_mm", "velocity_error_m_per_s", "cpu_seconds"])
        for result in results:
            case = [getattr(result.case, field) for field in FIELDS]
            numbers = (result.size_error, result.velocity_error, result.cpu_seconds)
            writer.writerow([*case, *(f"{number:.4g}" for number in numbers)])
