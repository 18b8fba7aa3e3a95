"""The table of transport runs, and names of its schemes for people."""

import csv
import math
from collections.abc import Iterable
from dataclasses import dataclass, replace
from pathlib import Path

MARKS = {"*": "one limiter factor for all components", "\u2020": "in primitive variables, kept admissible"}
LIMITERS = {
    "minmod(1)": "minmod",
    "minmod(1.3)": "minmod 1.3",
    "minmod(2)": "MC",
    "van_leer": "van Leer",
    "van_albada": "van Albada",
}
SCHEMES = {
    "piecewise_constant": "first order",
    "piecewise_linear": "",
    "piecewise_linear_common": "*",
    "primitive": "\u2020",
    "cweno3": "CWENO3",
}
INTEGRATORS = {"forward_euler": "forward Euler", "ssp_rk2": "RK2", "ssp_rk3": "RK3"}
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
NAMES = {  # within a sentence
    "advection": "smooth advection",
    "burgers_smooth": "smooth Burgers",
    "burgers_shock": "Burgers' shock",
    "sod": "Sod",
    "shu_osher": "Shu-Osher",
    "slotted_disk": "the slotted disk",
    "segregation_two_sizes": "two sizes",
    "segregation_five_sizes": "five sizes",
}
PLANES = {"slotted_disk"}  # the problems in two dimensions


@dataclass(frozen=True)
class Scheme:
    """A way to discretise."""

    scheme: str  # name of the reconstruction
    flux: str
    limiter: str
    integrator: str


@dataclass(frozen=True)
class Line:
    """The runs of one scheme on one problem, from coarse to fine; NaN where a run failed."""

    scheme: Scheme
    seconds: tuple[float, ...]
    evaluations: tuple[float, ...]
    errors: tuple[float, ...]
    cells: tuple[int, ...]
    is_same_for_all_fluxes: bool = False

    @property
    def parts(self) -> list[str]:
        """Names for people: of the reconstruction with its limiter, the integrator, and the flux if it matters."""
        limiter = _name(LIMITERS, self.scheme.limiter)
        scheme = _name(SCHEMES, self.scheme.scheme)
        kind = limiter + scheme if scheme in MARKS else " ".join(filter(None, (limiter, scheme)))
        flux = "" if self.is_same_for_all_fluxes else _name(FLUXES, self.scheme.flux)
        return [part for part in (kind, _name(INTEGRATORS, self.scheme.integrator), flux) if part]

    @property
    def label(self) -> str:
        return ", ".join(self.parts)


def _name(names: dict[str, str], name: str) -> str:
    return names.get(name, name.replace("_", " "))


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
        twin = next((i for i, other in enumerate(kept) if _are_equal(line, other)), None)
        if twin is None:
            kept.append(line)
        elif line.scheme.flux != kept[twin].scheme.flux:
            kept[twin] = replace(kept[twin], is_same_for_all_fluxes=True)
    return kept


def _are_equal(line: Line, other: Line) -> bool:
    """Whether both have the same errors, to the rounding that a shock may magnify."""
    return line.scheme.integrator == other.scheme.integrator and all(
        math.isclose(a, b, rel_tol=1e-3) for a, b in zip(line.errors, other.errors)
    )
