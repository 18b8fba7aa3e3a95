"""The chart of error against cost of the inclined-plane runs in one dimension."""

from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes

from incline_runs import Case, Result
from pareto import pareto_front
from picture import save, spread  # beside the plotting script, which incline_runs makes known

SIZE = (18, 11)  # [inch]
TITLES = {
    "A": "A: the flow does not feel the grains",
    "B": "B: viscosity follows the grain size",
    "D": "D: the same with remixing",
}
COLOURS = {  # by shape and transfer; dark enough for white paper, of different lightness
    ("linear", "apic"): "#1b1b6e",
    ("linear", "pic_flip"): "#7a5c99",
    ("quadratic", "apic"): "#0f8a6c",
    ("quadratic", "pic_flip"): "#d07a1e",
}
LINES = {"cells": "-", "nodes": ":"}
EXPLANATION = "solid: control volumes are cells; dotted: nodes; grey: no other run is both cheaper and more accurate"
LABEL_FONT = 12
LABEL_HEIGHT = 0.042  # [-], of a panel
LABEL_ROOM = 12  # factor by which the axis of cost goes on beyond the last point


class Measure(NamedTuple):
    """An error that is drawn."""

    member: str  # of Result
    label: str


Line = tuple[Case, list[float], list[float]]  # a way to discretise, its costs [s] and errors by rising cells

MEASURES = (
    Measure("size_error", "mean error of the mean grain size [mm]"),
    Measure("velocity_error", "greatest error of the velocity [m/s]"),
)


def draw_chart(results: Sequence[Result], stem: Path) -> list[Path]:
    """Draws both errors for each variant, and writes PNG and SVG."""
    results = [result for result in results if result.case.dimensions == 1]
    figure, panels = plt.subplots(2, len(TITLES), figsize=SIZE, sharex=True, sharey="row", layout="constrained")
    panels[0, 0].set(xscale="log", yscale="log")
    panels[1, 0].set(yscale="log")
    for row, measure in zip(panels, MEASURES):
        lines = [_draw_panel(axes, _of_variant(results, variant), measure) for axes, variant in zip(row, TITLES)]
        for axes, lines_here in zip(row, lines):  # once the axes have their last limits
            _label_lines(axes, lines_here)
        row[0].set_ylabel(measure.label)
    for axes, (variant, title) in zip(panels[0], TITLES.items()):
        axes.set_title(title, loc="left")
        _name_failures(axes, _of_variant(results, variant))
    for axes in panels[1]:
        axes.set_xlabel("CPU time [s]")
    figure.supxlabel(EXPLANATION, fontsize=LABEL_FONT + 2, color="0.35")
    costs = [result.cpu_seconds for result in results if np.isfinite(result.size_error)]
    panels[0, 0].set_xlim(0.7 * min(costs), LABEL_ROOM * max(costs))
    return save(figure, stem)


def _of_variant(results: Sequence[Result], variant: str) -> list[Result]:
    return [result for result in results if result.case.variant == variant]


def _draw_panel(axes: Axes, results: Sequence[Result], measure: Measure) -> list[Line]:
    """One variant and one error: a line for each way to discretise, through its numbers of cells."""
    _draw_front(axes, results, measure)
    lines = _lines_of(results, measure)
    for case, costs, errors in lines:
        colour = COLOURS[case.shape, case.transfer]
        axes.plot(costs, errors, LINES[case.control_volumes], color=colour, marker="o", markersize=7, linewidth=2)
    return lines


def _lines_of(results: Sequence[Result], measure: Measure) -> list[Line]:
    """Costs and errors of the runs that finished, for each way to discretise."""
    lines: dict[tuple[str, str, str], Line] = {}
    for result in sorted(results, key=lambda each: each.case.cells):
        case, error = result.case, getattr(result, measure.member)
        if not np.isfinite(error):
            continue
        _, costs, errors = lines.setdefault((case.shape, case.transfer, case.control_volumes), (case, [], []))
        costs.append(result.cpu_seconds)
        errors.append(error)
    return list(lines.values())


def _draw_front(axes: Axes, results: Sequence[Result], measure: Measure) -> None:
    """A broad grey band under the runs that no other run beats."""
    costs = [result.cpu_seconds for result in results]
    errors = [getattr(result, measure.member) for result in results]
    front = pareto_front(costs, errors, slack=0)
    axes.plot(
        [costs[run] for run in front],
        [errors[run] for run in front],
        color="0.85",
        linewidth=14,
        solid_capstyle="round",
        marker="o",
        markersize=17,
        zorder=0,
    )


def _label_lines(axes: Axes, lines: Sequence[Line]) -> None:
    """Names the lines at their right ends."""
    if not lines:
        return
    low, high = np.log10(axes.get_ylim())
    margin = LABEL_HEIGHT * (high - low)
    ends = [np.log10(errors[-1]) for _, _, errors in lines]
    places = 10 ** spread(ends, margin, low + margin, high - margin)
    right = 1.7 * max(cost for _, costs, _ in lines for cost in costs)
    for (case, costs, errors), place in zip(lines, places):
        axes.annotate(
            _name_of(case),
            xy=(costs[-1], errors[-1]),
            xytext=(right, place),
            va="center",
            fontsize=LABEL_FONT,
            color=COLOURS[case.shape, case.transfer],
            arrowprops={"arrowstyle": "-", "color": "0.6", "linewidth": 0.8, "shrinkB": 4, "relpos": (0, 0.5)},
        )


def _name_of(case: Case) -> str:
    transfer = {"apic": "APIC", "pic_flip": "FLIP"}[case.transfer]
    return f"{case.shape} {transfer}, {case.control_volumes}"


def _name_failures(axes: Axes, results: Sequence[Result]) -> None:
    """Says in the panel which runs did not reach their end."""
    failed: dict[str, list[str]] = {}
    for result in results:
        if not np.isfinite(result.size_error):
            failed.setdefault(_name_of(result.case), []).append(str(result.case.cells))
    lines = [f"{name}: failed at {' and '.join(cells)} cells" for name, cells in failed.items()]
    axes.text(
        0.03, 0.88, "\n".join(lines), transform=axes.transAxes, va="top", fontsize=LABEL_FONT, color="0.35"
    )
