"""The picture of error against cost of material points: a row for each shape, then for each number of points."""

import math
import textwrap
from collections.abc import Sequence
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.ticker import LogLocator, NullFormatter

from mpm_choice import EQUAL_COSTS, Choice
from mpm_runs import ERRORS, TITLES, Line
from pareto import cost_of_error
from picture import save  # beside the plotting script, which mpm_accuracy makes known

COLOURS = {
    "apic": "#b3202c",
    "tpic": "#c46a00",
    "aflip": "#8a4fb0",
    "flip": "#1f5fa8",
    "pic": "#7a7a7a",
    "xpic_2": "#0f8a6c",
}
STYLES = {1: ":", 2: "-", 3: "--"}  # by points along each axis of a cell
ORDERS = {  # musl, wide and pale, lies under usf, which costs nearly the same
    "usl": {"color": "black", "linestyle": "-", "linewidth": 2.5, "zorder": 3},
    "musl": {"color": "#d0149c", "linestyle": "-", "linewidth": 7, "zorder": 2, "alpha": 0.4},
    "usf": {"color": "#007a99", "linestyle": "--", "linewidth": 2.5, "zorder": 3},
}
FONT = 13
ERRORS_OF_A_LINE = 200  # between the largest and the least
PANEL = 2.9  # height of a row [inch]
BELOW = 3.8  # room for legend and sentences [inch]


def draw(problems: dict[str, list[Line]], chosen: dict[str, Sequence[Choice]], sentences: dict[str, str], stem: Path) -> list[Path]:
    """Errors over CPU time, a column for each problem: a row for each shape, with a line for each scheme through its
    meshes in the order usl, then a row for each number of points, with the runs of each order and what the cheapest
    of them costs. The grey band is that of all orders and points, in all rows."""
    schemes = [line.scheme for lines in problems.values() for line in lines]
    shapes = list(dict.fromkeys(scheme.shape for scheme in schemes))
    points = sorted({scheme.points_per_axis for scheme in schemes})
    rows = len(shapes) + len(points)
    height = PANEL * rows + BELOW
    figure, panels = plt.subplots(rows, len(problems), figsize=(13, height), squeeze=False, sharex="col", sharey="col")
    figure.subplots_adjust(left=0.075, right=0.985, top=1 - 0.6 / height, bottom=BELOW / height, wspace=0.28, hspace=0.32)
    for column, (problem, lines) in zip(panels.T, problems.items()):
        for axes, shape in zip(column, shapes):
            _draw_lines(axes, [line for line in lines if line.scheme.order == "usl" and line.scheme.shape == shape])
            axes.set_title(f"{shape}, usl", loc="right", fontsize=FONT, pad=2)
            _circle(axes, [choice for choice in chosen[problem] if choice.scheme.order == "usl" and choice.scheme.shape == shape])
        for axes, number in zip(column[len(shapes) :], points):
            _draw_orders(axes, [line for line in lines if line.scheme.points_per_axis == number])
            _circle(axes, [choice for choice in chosen[problem] if choice.scheme.points_per_axis == number])
            axes.set_title(f"{number}² points, all shapes", loc="right", fontsize=FONT, pad=2)
        for axes in column:
            _dress(axes, lines)
        column[0].annotate(TITLES[problem], (0.5, 1), (0, 24), "axes fraction", "offset points", ha="center", fontsize=16)
        column[len(column) // 2].set_ylabel(ERRORS[problem], fontsize=FONT)
        column[-1].set_xlabel("CPU time [s]", fontsize=FONT)
    handles = [Line2D([], [], color=colour, label=name, linewidth=3) for name, colour in COLOURS.items()]
    handles += [Line2D([], [], color="black", linestyle=style, label=f"{number}² points", linewidth=2) for number, style in STYLES.items()]
    handles += [Line2D([], [], label=name, **style) for name, style in ORDERS.items()]
    figure.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, (BELOW - 0.6) / height), ncol=4, fontsize=FONT, frameon=False)
    text = "\n".join(textwrap.fill(f"{TITLES[name]}: {words}", 122) for name, words in sentences.items())
    figure.text(0.5, (BELOW - 1.6) / height, text, ha="center", va="top", fontsize=FONT)
    return save(figure, stem)


def _runs(lines: Sequence[Line]) -> tuple[list[float], list[float]]:
    return [cost for line in lines for cost in line.seconds], [error for line in lines for error in line.errors]


def _least_costs(lines: Sequence[Line]) -> tuple[list[float], list[float]]:
    """What the cheapest of these schemes costs at an error, from the least to where the least cost of all is enough."""
    finite = [error for error in _runs(lines)[1] if math.isfinite(error)]
    errors = [float(error) for error in np.geomspace(min(finite), max(finite), ERRORS_OF_A_LINE)]
    costs = [min(cost_of_error(line.seconds, line.errors, error) for line in lines) for error in errors]
    first = next(i for i, cost in enumerate(costs) if math.isfinite(cost))
    end = next(i + 1 for i, cost in enumerate(costs) if cost <= (1 + EQUAL_COSTS) * costs[-1])
    return costs[first:end], errors[first:end]


def _dress(axes: Axes, lines: Sequence[Line]) -> None:
    axes.set(xscale="log", yscale="log")
    axes.plot(*_least_costs(lines), color="0.85", linewidth=14, solid_capstyle="round", zorder=0)
    axes.xaxis.set_major_locator(LogLocator(numticks=5))
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.tick_params(labelsize=FONT, which="both", labelbottom=True)


def _circle(axes: Axes, chosen: Sequence[Choice]) -> None:
    for choice in chosen:
        axes.plot(choice.seconds, choice.reached, "o", markersize=13, markerfacecolor="none", color="black", markeredgewidth=2)


def _draw_lines(axes: Axes, lines: Sequence[Line]) -> None:
    for line in lines:
        colour, style = COLOURS[line.scheme.transfer], STYLES[line.scheme.points_per_axis]
        axes.plot(line.seconds, line.errors, color=colour, linestyle=style, linewidth=1.6, marker=".", markersize=6)


def _draw_orders(axes: Axes, lines: Sequence[Line]) -> None:
    for order, style in ORDERS.items():
        those = [line for line in lines if line.scheme.order == order]
        axes.plot(*_runs(those), ".", color=style["color"], markersize=5, alpha=0.35)
        axes.plot(*_least_costs(those), **style)
