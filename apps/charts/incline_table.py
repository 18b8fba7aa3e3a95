"""The results of the inclined-plane runs as a Markdown table."""

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
    cells = (
        case.variant,
        case.dimensions,
        case.shape,
        case.transfer,
        case.control_volumes,
        case.cells,
        f"{result.size_error:.2g}",
        f"{result.velocity_error:.2g}",
        f"{result.cpu_seconds:.2g}" if result.cpu_seconds < 10 else f"{result.cpu_seconds:.0f}",
    )
    return f"| {' | '.join(map(str, cells))} |\n"
