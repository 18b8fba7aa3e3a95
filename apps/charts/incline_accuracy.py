#!/usr/bin/python3
"""Error against cost of the inclined-plane flow, over shape, transfer, control volumes and cells.

Writes incline_accuracy.csv, .md, .png and .svg. The errors are those against apps/plot/reference_incline.csv.
"""

import argparse
import itertools
import tempfile
from pathlib import Path

from incline_chart import draw_chart
from incline_runs import Case, run_case, write_results
from incline_table import write_table

SHAPES = ("linear", "quadratic")
TRANSFERS = ("apic", "pic_flip")
CONTROL_VOLUMES = ("cells", "nodes")
FINE_LIMIT = 600  # [s], several times what a run with 204 cells takes


def cases_of(fine: bool, plane: bool) -> list[Case]:
    """All ways to discretise the column, and with `plane` those of the plane at 51 cells."""
    cells = (51, 102, 204) if fine else (51, 102)
    columns = itertools.product("ABD", (1,), SHAPES, TRANSFERS, CONTROL_VOLUMES, cells)
    planes = itertools.product("B", (2,), SHAPES, TRANSFERS, CONTROL_VOLUMES, (51,)) if plane else ()
    return [Case(*choice) for choice in (*columns, *planes)]


def read_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--scree", type=Path, required=True, help="the program")
    parser.add_argument("--output", type=Path, default=Path("out/charts"), help="directory of the results")
    parser.add_argument("--cpu-limit", type=int, default=60, help="CPU seconds of one run, beyond which it failed")
    parser.add_argument("--fine", action="store_true", help="204 cells too: an hour, with --cpu-limit 600")
    parser.add_argument("--plane", action="store_true", help="the two-dimensional scene too: minutes")
    arguments = parser.parse_args()
    if arguments.fine and arguments.cpu_limit < FINE_LIMIT:
        parser.error(f"--fine needs --cpu-limit {FINE_LIMIT} or more")
    return arguments


def main() -> None:
    arguments = read_arguments()
    arguments.output.mkdir(parents=True, exist_ok=True)
    results = []
    cases = cases_of(arguments.fine, arguments.plane)
    with tempfile.TemporaryDirectory() as scratch:
        for number, case in enumerate(cases, 1):
            result = run_case(arguments.scree, case, Path(scratch) / case.name, arguments.cpu_limit)
            results.append(result)
            print(
                f"{number:3d}/{len(cases)} {case.name:35s} {result.size_error:9.3g} mm "
                f"{result.velocity_error:9.3g} m/s {result.cpu_seconds:7.1f} s",
                flush=True,
            )
    stem = arguments.output / "incline_accuracy"
    write_results(results, stem.with_suffix(".csv"))
    write_table(results, stem.with_suffix(".md"))
    draw_chart(results, stem)
    for suffix in (".csv", ".md", ".png", ".svg"):
        print(stem.with_suffix(suffix))


if __name__ == "__main__":
    main()
