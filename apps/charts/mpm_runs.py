"""The table of runs of material points, and names for people."""

import csv
from dataclasses import dataclass
from pathlib import Path

TITLES = {
    "swing": "Swing along both axes",
    "turning_ring": "Turning ring",
    "collapse": "Collapse of a column",
}
ERRORS = {
    "swing": "distance from the exact places / amplitude",
    "turning_ring": "distance from the exact places / way",
    "collapse": "share of the mass that lies elsewhere",
}


@dataclass(frozen=True)
class Scheme:
    """A way to step material points."""

    shape: str
    transfer: str
    order: str
    points_per_axis: int

    def __str__(self) -> str:
        order = "" if self.order == "usl" else f", {self.order}"
        return f"{self.shape} {self.transfer}, {self.points_per_axis}² points{order}"


@dataclass(frozen=True)
class Line:
    """The runs of one scheme on one problem, from coarse meshes to fine ones."""

    scheme: Scheme
    cells: tuple[int, ...]
    seconds: tuple[float, ...]
    errors: tuple[float, ...]  # NaN for a run that ended early


def read_lines(table: Path) -> dict[str, list[Line]]:
    """The lines of each problem, in the order of the table."""
    rows: dict[str, dict[Scheme, list[dict[str, str]]]] = {}
    with table.open(newline="", encoding="utf-8") as text:
        for row in csv.DictReader(text):
            scheme = Scheme(row["shape"], row["transfer"], row["order"], int(row["points_per_axis"]))
            rows.setdefault(row["problem"], {}).setdefault(scheme, []).append(row)
    return {
        problem: [
            Line(
                scheme,
                tuple(int(row["cells"]) for row in runs),
                tuple(float(row["cpu_seconds"]) for row in runs),
                tuple(float(row["error"]) for row in runs),
            )
            for scheme, runs in schemes.items()
        ]
        for problem, schemes in rows.items()
    }
