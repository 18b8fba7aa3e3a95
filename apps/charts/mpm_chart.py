"""The picture of error against cost of material points: above every scheme, below the orders of the step."""

import textwrap
from collections.abc import Sequence
from pathlib import Path

import matplotlib.pyplot as plt
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.ticker import LogLocator, NullFormatter

from mpm_choice import POINTS_OF_ORDERS, Choice
from mpm_runs import ERRORS, TITLES, Line
from pareto import pareto_front
from picture import save  # beside the plotting script, which mpm_accuracy makes known

COLOURS = {
    "apic": "#b3202c",
    "tpic": "#c46a00",
    "aflip": "#8a4fb0",
    "flip": "#1f5fa8",
    "pic": "#7a7a7a",
    "xpic_2": "#0f8a6c",
}
STYLES = {"linear": ":", "quadratic": "-", "cubic": "--", "gimp": "-."}
MARKERS = {1: ".", 2: "s", 3: "^"}
ORDERS = {"usl": ("black", "-"), "musl": ("#c46a00", "--"), "usf": ("#1f5fa8", ":")}
FONT = 13


def draw(problems: dict[str, list[Line]], chosen: dict[str, Sequence[Choice]], sentences: dict[str, str], stem: Path) -> list[Path]:
    """Errors over CPU time, a column for each problem. Above a line for each scheme through its meshes, in the order
    usl; below the runs of each order and what is worth its cost among them. The grey band is that of all runs."""
    figure, panels = plt.subplots(2, len(problems), figsize=(13, 15), squeeze=False, sharex="col", sharey="col")
    figure.subplots_adjust(left=0.075, right=0.985, top=0.965, bottom=0.235, wspace=0.28, hspace=0.3)
    for (above, below), (problem, lines) in zip(panels.T, problems.items()):
        _draw_lines(above, [line for line in lines if line.scheme.order == "usl"])
        _draw_orders(below, [line for line in lines if line.scheme.points_per_axis == POINTS_OF_ORDERS])
        for axes in (above, below):
            _dress(axes, lines)
            axes.set_ylabel(ERRORS[problem], fontsize=FONT)
        for choice in chosen[problem]:
            above.plot(choice.seconds, choice.error, "o", markersize=13, markerfacecolor="none", color="black", markeredgewidth=2)
        above.set_title(TITLES[problem], fontsize=16)
        below.set_xlabel("CPU time [s]", fontsize=FONT)
    shapes = dict.fromkeys(line.scheme.shape for lines in problems.values() for line in lines)
    handles = [Line2D([], [], color=colour, label=name, linewidth=3) for name, colour in COLOURS.items()]
    handles += [Line2D([], [], color="black", linestyle=STYLES[name], label=name, linewidth=2) for name in shapes]
    handles += [Line2D([], [], color="black", linestyle="", marker=mark, label=f"{points}² points") for points, mark in MARKERS.items()]
    figure.legend(handles=handles, loc="center", bbox_to_anchor=(0.5, 0.585), ncol=7, fontsize=FONT, frameon=False)
    handles = [Line2D([], [], color=colour, linestyle=style, label=name, linewidth=3) for name, (colour, style) in ORDERS.items()]
    figure.legend(handles=handles, loc="center", bbox_to_anchor=(0.5, 0.185), ncol=3, fontsize=FONT, frameon=False)
    text = "\n".join(textwrap.fill(f"{TITLES[name]}: {words}", 122) for name, words in sentences.items())
    figure.text(0.5, 0.085, text, ha="center", va="center", fontsize=FONT)
    return save(figure, stem)


def _runs(lines: Sequence[Line]) -> tuple[list[float], list[float]]:
    return [cost for line in lines for cost in line.seconds], [error for line in lines for error in line.errors]


def _front(lines: Sequence[Line]) -> tuple[list[float], list[float]]:
    costs, errors = _runs(lines)
    front = pareto_front(costs, errors)
    return [costs[i] for i in front], [errors[i] for i in front]


def _dress(axes: Axes, lines: Sequence[Line]) -> None:
    axes.set(xscale="log", yscale="log")
    axes.plot(*_front(lines), color="0.85", linewidth=14, solid_capstyle="round", zorder=0)
    axes.xaxis.set_major_locator(LogLocator(numticks=5))
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.tick_params(labelsize=FONT, which="both", labelbottom=True)


def _draw_lines(axes: Axes, lines: Sequence[Line]) -> None:
    for line in lines:
        axes.plot(
            line.seconds,
            line.errors,
            color=COLOURS[line.scheme.transfer],
            linestyle=STYLES[line.scheme.shape],
            linewidth=1.4,
            marker=MARKERS[line.scheme.points_per_axis],
            markersize=4,
        )


def _draw_orders(axes: Axes, lines: Sequence[Line]) -> None:
    for order, (colour, style) in ORDERS.items():
        those = [line for line in lines if line.scheme.order == order]
        axes.plot(*_runs(those), ".", color=colour, markersize=5, alpha=0.35)
        axes.plot(*_front(those), color=colour, linestyle=style, linewidth=2.5)
