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


NEWTONIAN = {"law": "newtonian", "viscosity": 750}
SIZE_DEPENDENT = {"law": "size_dependent_newtonian", "viscosity_per_size": 1e6}
VARIANTS = {  # what each variant has in [rheology] and in [segregation]
    "A": (NEWTONIAN, {"closure": "shear_rate", "remixing": 0}),
    "B": (SIZE_DEPENDENT, {"closure": "size_weighted_shear_rate", "reference_size": 0.75e-3, "remixing": 0}),
    "D": (SIZE_DEPENDENT, {"closure": "shear_rate", "remixing": 0.03}),
}


def variant_of(scene: dict[str, Any]) -> str | None:
    """The variant that a scene solves; None if the table has no solution of it."""
    if not _is_the_incline(scene):
        return None
    segregation = {"remixing": 0} | scene["segregation"]
    for variant, (law, closure) in VARIANTS.items():
        if _has(scene["rheology"], law) and _has(segregation, closure):
            return variant
    return None


def _has(table: dict[str, Any], wanted: dict[str, Any]) -> bool:
    return all(table.get(key) == value for key, value in wanted.items())


def _is_the_incline(scene: dict[str, Any]) -> bool:
    """Whether depth, slope, density, grains and strength of segregation are those of the table."""
    try:
        return (
            depth_range(scene) == (0, 1)
            and scene["boundaries"]["y_low"] == "no_slip"
            and scene["gravity"] == {"magnitude": 9.81, "slope_degrees": 18}
            and scene["rheology"]["density"] == 1000
            and scene["grains"]["diameters"] == [0.5e-3, 1e-3]
            and scene["grains"]["fractions"] == [0.5, 0.5]
            and scene["segregation"]["c"] == 0.05
        )
    except (KeyError, IndexError):
        return False
