#!/usr/bin/env python3
"""The rows that speed is judged by, where there is one beside a program that shows what the machine can do."""

import argparse
import json
import re
import subprocess
from dataclasses import dataclass
from pathlib import Path

FIELDS = 4  # doubles of a node that one vector holds
BYTES_ASKED = 1.1  # of a point over those of its columns, at most
SORT_ASKED = 0.05  # of the time of the steps between two sorts, at most


@dataclass
class Row:
    """A row of mpm_bench, the row of the limit it is held against, and the ratio asked of it."""

    name: str
    dimensions: int
    limit: str  # how the limit's row begins
    asked: float
    threads: int = 1
    support: int = 3
    has_increment: bool = False


def rows() -> list[Row]:
    result = []
    for d in (2, 3):
        result += [
            Row(f"{d}D_apic_quadratic", d, f"{d}D APIC quad Ns=0 E1", 0.7),
            Row(f"{d}D_apic_quadratic_2_classes", d, f"{d}D APIC quad Ns=2 E1", 0.75),
            Row(f"{d}D_apic_quadratic_8_classes", d, f"{d}D APIC quad Ns=8 E1", 0.75),
            Row(f"{d}D_flip_quadratic", d, f"{d}D FLIP quad Ns=0 E1", 0.7, has_increment=True),
            Row(f"{d}D_flip_linear", d, f"{d}D FLIP lin Ns=0 E1", 0.7, support=2, has_increment=True),
            Row(f"{d}D_apic_quadratic_2_threads", d, f"{d}D APIC quad Ns=0 E1", 0.7, threads=2),
        ]
    return result


# Of one row against another, both scree's.
WITHIN = [("{}D_apic_quadratic_2_threads", "{}D_apic_quadratic", 1.7),
          ("{}D_apic_quadratic_2e6_points", "{}D_apic_quadratic", 0.75),
          ("{}D_apic_quadratic_2_percent_filled", "{}D_apic_quadratic", 0.8)]

# Cell-classes and cell-steps of transport: benchmark, its program, classes of the limit's row or none, what is asked
# [millions a second].
OF_TRANSPORT = [("probe_rates<2>", "transport_bench", 2, 120),
                ("probe_rates<8>", "transport_bench", 8, 120),
                ("euler_step", "transport_bench", None, 20),
                ("step/triangles_hilbert/real_time", "transport_unstructured_bench", None, 5)]


def to_nodes(axes: int, support: int, value: bool, slope: bool) -> int:
    """Floating-point operations of add_to_nodes in libs/mpm/src/kernels/stencil_loops.hpp."""
    if axes == 1:
        return support * 2 * FIELDS * (value + slope)
    here = FIELDS * ((1 if value else 0) + ((2 if value else 1) + axes - 1 if slope else 0))
    return support * (here + to_nodes(axes - 1, support, True, slope))


def affine_to_nodes(axes: int, support: int) -> int:
    """Those of add_affine there."""
    if axes == 1:
        return support * 3 * FIELDS
    return support * ((1 + axes) * FIELDS + affine_to_nodes(axes - 1, support))


def from_nodes(axes: int, support: int, slope: bool) -> int:
    """Those of sum_near in libs/mpm/src/kernels/near_loops.hpp for one field, of packs whose stencils begin at one
    node."""
    if axes == 1:
        return support * 2 * (1 + slope)
    here = 2 * (1 + (axes if slope else 0))
    return support * (here + from_nodes(axes - 1, support, slope))


def moments_from_nodes(axes: int, support: int) -> int:
    """Those of moments_near there."""
    if axes == 1:
        return support * 3
    return support * (1 + 2 * axes + moments_from_nodes(axes - 1, support))


def operations(row: Row) -> int:
    """Of a point in the loops over the nodes of its stencil: not of its weights, its law, or the nodes' own."""
    d, s = row.dimensions, row.support
    if not row.has_increment:
        return affine_to_nodes(d, s) + d * moments_from_nodes(d, s)
    return (to_nodes(d, s, True, False) + to_nodes(d, s, False, True)
            + d * (from_nodes(d, s, True) + from_nodes(d, s, False)))


def run(*command: str) -> str:
    environment = {"OMP_WAIT_POLICY": "passive", "PATH": "/usr/bin:/bin"}
    return subprocess.run(command, check=True, capture_output=True, text=True, env=environment).stdout


def rate_of_limit(folder: Path, row: Row) -> float:
    fill = {2: 158, 3: 23}[row.dimensions]
    text = run(str(folder / f"step{row.dimensions}d"), "time", f"{row.dimensions}d", str(fill),
               str(row.threads), row.limit.removeprefix(f"{row.dimensions}D "), "1")
    clock = r"per cpu-s +([\d.]+)" if row.threads == 1 else r"([\d.]+) Mpts/s"
    found = re.search(re.escape(row.limit) + ".*?" + clock, text)
    if not found:
        raise SystemExit(f"{folder}/step{row.dimensions}d does not print the row '{row.limit}':\n{text}")
    return float(found[1])


def measure(bench: Path, name: str, threads: int = 1) -> dict:
    """A row of a benchmark, its "rate" in millions a second: of CPU time on one thread, as others run too."""
    text = run(str(bench), f"--benchmark_filter=^{name}(/|$)", "--benchmark_format=json")
    row = json.loads(text)["benchmarks"][0]
    by_the_clock = row["name"].endswith("real_time") and threads == 1
    row["rate"] = row["items_per_second"] / 1e6 * (row["real_time"] / row["cpu_time"] if by_the_clock else 1)
    return row


def rate_of_segregation(folder: Path, classes: int) -> float:
    text = run(str(folder / "segregation"))
    return float(re.search(rf"Ns={classes} threads 1:.*face-once +([\d.]+)", text)[1])


def transport(benches: Path, limits: Path, rounds: int) -> None:
    print("million cell-classes or cell-steps / s     scree limit ratio asked of scree")
    for name, program, classes, asked in OF_TRANSPORT:
        rate = max(measure(benches / program, name)["rate"] for _ in range(rounds))
        beside = f"{'-':>5} {'-':>5}"
        if classes:
            limit = max(rate_of_segregation(limits, classes) for _ in range(rounds))
            beside = f"{limit:5.1f} {rate / limit:5.2f}"
        print(f"{name:38} {rate:9.1f} {beside} {asked:5}", flush=True)


def sorting(bench: Path, dimensions: int, rounds: int) -> None:
    """What sorts take of the time where they are due soonest: all points go a fifth of a cell in a step, the default
    share of the advective limit."""
    name = f"{dimensions}D_apic_quadratic_stream"
    stream = max((measure(bench, name) for _ in range(rounds)), key=lambda one: one["rate"])
    whole = 1e9 / stream["items_per_second"]  # by the clock, as the phases are
    print(f"{name}: {whole:.1f} ns per point, of which sorts take {stream['sort_ns']:.1f}, "
          f"{stream['sort_ns'] / whole:.1%}; asked {SORT_ASKED:.0%} of what runs do")


def peak(folder: Path) -> float | None:
    """Multiply-adds of doubles on one core [Gflop/s]; none where the program that makes them is missing."""
    if not (folder / "machine").exists():
        return None
    text = run(str(folder / "machine"))
    return max(float(g) for g in re.findall(r"fma double \S+ +threads 1 : +([\d.]+)", text))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--bench", type=Path, required=True, help="folder of scree's benchmarks")
    parser.add_argument("--limits", type=Path, required=True,
                        help="folder of step2d, step3d, segregation and, if it compiles here, machine")
    parser.add_argument("--rounds", type=int, default=2, help="each takes both in turn; the best counts")
    options = parser.parse_args()
    points = options.bench / "mpm_bench"

    most = peak(options.limits)
    print(f"one core makes {most:.1f} Gflop/s by multiply-adds of doubles" if most else
          "how much one core makes by multiply-adds is not known: there is no program 'machine'")
    print(f"{'million points x steps / s':34} scree limit ratio asked |  ns per point: scatter nodes gather"
          " | loops over nodes [Gflop/s, of peak] | bytes per point, over columns, asked")
    best = {}
    for row in rows():
        limit = max(rate_of_limit(options.limits, row) for _ in range(options.rounds))
        measured = max((measure(points, row.name, row.threads) for _ in range(options.rounds)),
                       key=lambda one: one["rate"])
        rate = measured["rate"]
        best[row.name] = rate
        phases = " ".join(f"{measured[phase]:6.1f}" for phase in ("scatter_ns", "nodes_ns", "gather_ns"))
        busy = measured["scatter_ns"] + measured["gather_ns"]
        speed = operations(row) / busy
        share = f"{speed / (most * row.threads):4.0%}" if most else f"{'-':>4}"
        print(f"{row.name:34} {rate:5.1f} {limit:5.1f} {rate / limit:5.2f} {row.asked:5.2f} |"
              f"        {phases}        | {speed:5.1f} {share}"
              f" | {measured['bytes']:4.0f} {measured['bytes'] / measured['bytes_in_use']:5.3f} {BYTES_ASKED:4.2f}",
              flush=True)
    print("one row of scree over another")
    for d in (2, 3):
        for name, other, asked in WITHIN:
            name, other = name.format(d), other.format(d)
            if name not in best:
                best[name] = max(measure(points, name)["rate"] for _ in range(options.rounds))
            print(f"{name:34} {best[name]:5.1f} {best[other]:5.1f} {best[name] / best[other]:5.2f} {asked:5.2f}")
    for d in (2, 3):
        sorting(points, d, options.rounds)
    transport(options.bench, options.limits, options.rounds)


if __name__ == "__main__":
    main()
