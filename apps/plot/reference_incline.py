"""Reference profiles of the inclined-plane flow, from reference_incline.csv."""

import csv
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from scene import depth_range

TABLE = Path(__file__).with_name("reference_incline.csv")


class ReferenceProfile(NamedTuple):
    """Averages over equal parts of the depth, from the base up."""

    time: float  # [s]
    y: np.ndarray  # [m]
    mean_size: np.ndarray  # [mm]
    velocity: np.ndarray  # [m/s]


def read_reference(variant: str) -> list[ReferenceProfile]:
    """The profiles of one variant ("A", "B" or "D") in the order of time."""
    with TABLE.open(newline="", encoding="utf-8") as table:
        lines = (line for line in table if not line.startswith("#"))
        rows = [row for row in csv.DictReader(lines) if row["variant"] == variant]
    profiles = []
    for time in sorted({float(row["time_s"]) for row in rows}):
        here = [row for row in rows if float(row["time_s"]) == time]
        columns = (
            np.array([float(row[name]) for row in here])
            for name in ("y_m", "mean_size_mm", "velocity_m_per_s")
        )
        profiles.append(ReferenceProfile(time, *columns))
    return profiles


def variant_of(scene: dict[str, Any]) -> str | None:
    """The variant that a scene solves; None if the table has no solution of it."""
    if not _is_the_incline(scene):
        return None
    law = scene["rheology"].get("law")
    segregation = scene["segregation"]
    key = (segregation.get("closure"), law, segregation.get("remixing", 0))
    size_viscosity = scene["rheology"].get("viscosity_per_size")
    if key == ("shear_rate", "newtonian", 0) and scene["rheology"].get("viscosity") == 750:
        return "A"
    if law != "size_dependent_newtonian" or size_viscosity != 1e6:
        return None
    if key[0] == "size_weighted_shear_rate" and key[2] == 0 and segregation.get("reference_size") == 0.75e-3:
        return "B"
    return "D" if key[0] == "shear_rate" and key[2] == 0.03 else None


def _is_the_incline(scene: dict[str, Any]) -> bool:
    """Whether depth, slope, density, grains and strength of segregation are those of the table."""
    try:
        return (
            depth_range(scene) == (0, 1)
            and scene["gravity"] == {"magnitude": 9.81, "slope_degrees": 18}
            and scene["rheology"]["density"] == 1000
            and scene["grains"]["diameters"] == [0.5e-3, 1e-3]
            and scene["grains"]["fractions"] == [0.5, 0.5]
            and scene["segregation"]["c"] == 0.05
        )
    except (KeyError, IndexError):
        return False
