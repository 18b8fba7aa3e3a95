"""The table of rheology runs, and names of its methods for people."""

import csv
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

METHODS = {
    "explicit": "explicit Euler",
    "rkl2": "RKL2",
    "implicit": "backward Euler",
    "two_solves": "two solves",
    "closed_return": "closed return",
    "cvode": "CVODE",
}
TITLES = {
    "newtonian_layer": "Start-up of a viscous layer",
    "bingham_layer": "Start-up of Bingham's fluid",
    "granular_point": "granular_elastoviscoplastic",
    "yield_stress_point": "elastic_herschel_bulkley",
}
PARAMETERS = {"newtonian_layer": "µ = {} Pa s", "bingham_layer": "m = {} s"}
LAYERS = tuple(PARAMETERS)
POINTS = ("granular_point", "yield_stress_point")


@dataclass(frozen=True)
class Line:
    """The runs of one method on one problem, from long steps to short ones."""

    method: str
    parameter: float
    steps: tuple[float, ...]
    ratio: tuple[float, ...]  # of the step to the explicit limit
    applications: tuple[float, ...]
    seconds: tuple[float, ...]
    errors: tuple[float, ...]


def seconds(line: Line) -> Sequence[float]:
    return line.seconds


def applications(line: Line) -> Sequence[float]:
    return line.applications


def read_lines(table: Path) -> dict[str, dict[float, list[Line]]]:
    """The lines of each problem and parameter, in the order of the table."""
    rows: dict[str, dict[float, dict[str, list[dict[str, str]]]]] = {}
    with table.open(newline="", encoding="utf-8") as text:
        for row in csv.DictReader(text):
            parameters = rows.setdefault(row["problem"], {})
            parameters.setdefault(float(row["parameter"]), {}).setdefault(row["method"], []).append(row)
    return {
        problem: {
            parameter: [_line_of(method, parameter, runs) for method, runs in methods.items()]
            for parameter, methods in parameters.items()
        }
        for problem, parameters in rows.items()
    }


def _line_of(method: str, parameter: float, rows: list[dict[str, str]]) -> Line:
    names = ("steps", "ratio", "applications", "cpu_seconds", "error")
    return Line(method, parameter, *(tuple(float(row[name]) for row in rows) for name in names))
