"""The table of transport runs, and names of its schemes for people."""

import csv
import math
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

LIMITERS = {
    "minmod(1)": "minmod",
    "minmod(1.3)": "minmod 1.3",
    "minmod(2)": "MC",
    "van_leer": "van Leer",
    "van_albada": "van Albada",
}
SCHEMES = {"piecewise_constant": "first order", "piecewise_linear_common": "common", "piecewise_linear": ""}
INTEGRATORS = {"forward_euler": "Euler", "ssp_rk2": "RK2", "ssp_rk3": "RK3"}
FLUXES = {"kurganov_tadmor": "KT", "kurganov_noelle_petrova": "KNP"}
TITLES = {
    "advection": "Smooth advection",
    "burgers_smooth": "Burgers before the shock",
    "burgers_shock": "Burgers with a shock",
    "sod": "Sod's shock tube",
    "shu_osher": "Shu-Osher: a shock through waves",
    "slotted_disk": "Slotted disk, one turn",
    "segregation_two_sizes": "Two grain sizes that overtake",
    "segregation_five_sizes": "Five grain sizes that part",
}
PLANES = {"slotted_disk"}  # the problems in two dimensions


@dataclass(frozen=True)
class Scheme:
    """A way to discretise."""

    scheme: str  # name of the reconstruction
    flux: str
    limiter: str
    integrator: str

    @property
    def label(self) -> str:
        """Short, for a picture."""
        limiter = LIMITERS.get(self.limiter, self.limiter.replace("_", " "))
        scheme = SCHEMES.get(self.scheme, self.scheme.replace("_", " "))
        integrator = INTEGRATORS.get(self.integrator, self.integrator.replace("_", " "))
        parts = (" ".join(filter(None, (limiter, scheme))), integrator, FLUXES.get(self.flux, self.flux))
        return ", ".join(filter(None, parts))


@dataclass(frozen=True)
class Line:
    """The runs of one scheme on one problem, from coarse to fine; NaN where a run failed."""

    scheme: Scheme
    seconds: tuple[float, ...]
    evaluations: tuple[float, ...]
    errors: tuple[float, ...]
    cells: tuple[int, ...]


def read_lines(table: Path) -> dict[str, list[Line]]:
    """The lines of each problem, in the order of the table. Of schemes that do the same, the first."""
    rows: dict[str, dict[Scheme, list[dict[str, str]]]] = {}
    with table.open(newline="", encoding="utf-8") as text:
        for row in csv.DictReader(text):
            scheme = Scheme(row["scheme"], row["flux"], row["limiter"], row["integrator"])
            rows.setdefault(row["problem"], {}).setdefault(scheme, []).append(row)
    return {problem: _distinct(map(_line_of, lines.items())) for problem, lines in rows.items()}


def _line_of(item: tuple[Scheme, list[dict[str, str]]]) -> Line:
    scheme, rows = item
    rows = sorted(rows, key=lambda row: int(row["n"]))
    numbers = (tuple(float(row[name]) for row in rows) for name in ("cpu_seconds", "flux_evaluations", "l1"))
    return Line(scheme, *numbers, tuple(int(row["n"]) for row in rows))


def _distinct(lines: Iterable[Line]) -> list[Line]:
    """Without the lines that equal an earlier one, such as two fluxes that are one where waves go one way."""
    kept: list[Line] = []
    for line in lines:
        if not any(_are_equal(line, other) for other in kept):
            kept.append(line)
    return kept


def _are_equal(line: Line, other: Line) -> bool:
    return line.scheme.integrator == other.scheme.integrator and all(
        math.isclose(a, b, rel_tol=1e-6) for a, b in zip(line.errors, other.errors)
    )
