"""The results of the inclined-plane runs as a Markdown table."""

import math
from collections.abc import Sequence
from pathlib import Path

from incline_runs import Result

HEADER = (
    "| variant | D | shape | transfer | control volumes | cells | size error [mm] | velocity error [m/s] | CPU [s] |\n"
    "|---|---|---|---|---|---|---|---|---|\n"
)


def write_table(results: Sequence[Result], path: Path) -> None:
    """One row for each run."""
    path.write_text(HEADER + "".join(map(_row, results)), encoding="utf-8")


def _row(result: Result) -> str:
    case = result.case
    case_cells = (case.variant, case.dimensions, case.shape, case.transfer, case.control_volumes, case.cells)
    if math.isfinite(result.size_error):
        errors = (f"{result.size_error:.2g}", f"{result.velocity_error:.2g}")
    else:
        errors = ("failed", "failed")
    return f"| {' | '.join(map(str, (*case_cells, *errors, _seconds(result.cpu_seconds))))} |\n"


def _seconds(seconds: float) -> str:
    return f"{seconds:.2g}" if seconds < 10 else f"{seconds:.0f}"
