"""The picture of error against cost of material points: a row for each shape, and one for the orders of the step."""

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
STYLES = {1: ":", 2: "-", 3: "--"}  # by points along each axis of a cell
ORDERS = {"usl": ("black", "-"), "musl": ("#c46a00", "--"), "usf": ("#1f5fa8", ":")}
FONT = 13
PANEL = 3.3  # height of a row [inch]
BELOW = 3.9  # room for legend and sentences [inch]


def draw(problems: dict[str, list[Line]], chosen: dict[str, Sequence[Choice]], sentences: dict[str, str], stem: Path) -> list[Path]:
    """Errors over CPU time, a column for each problem: a row for each shape, with a line for each scheme through its
    meshes in the order usl, and last the runs of each order and what is worth its cost among them. The grey band is
    that of all runs, in all rows."""
    shapes = list(dict.fromkeys(line.scheme.shape for lines in problems.values() for line in lines))
    height = PANEL * (len(shapes) + 1) + BELOW
    figure, panels = plt.subplots(len(shapes) + 1, len(problems), figsize=(13, height), squeeze=False, sharex="col", sharey="col")
    figure.subplots_adjust(left=0.075, right=0.985, top=1 - 0.5 / height, bottom=BELOW / height, wspace=0.28, hspace=0.2)
    for column, (problem, lines) in zip(panels.T, problems.items()):
        for axes, shape in zip(column, shapes):
            _draw_lines(axes, [line for line in lines if line.scheme.order == "usl" and line.scheme.shape == shape])
            axes.text(0.97, 0.95, shape, transform=axes.transAxes, ha="right", va="top", fontsize=FONT)
            for choice in chosen[problem]:
                if choice.scheme.shape == shape:
                    axes.plot(choice.seconds, choice.error, "o", markersize=13, markerfacecolor="none", color="black", markeredgewidth=2)
        _draw_orders(column[-1], [line for line in lines if line.scheme.points_per_axis == POINTS_OF_ORDERS])
        column[-1].text(0.97, 0.95, f"all shapes, {POINTS_OF_ORDERS}² points", transform=column[-1].transAxes, ha="right", va="top", fontsize=FONT)
        for axes in column:
            _dress(axes, lines)
        column[0].set_title(TITLES[problem], fontsize=16)
        column[len(column) // 2].set_ylabel(ERRORS[problem], fontsize=FONT)
        column[-1].set_xlabel("CPU time [s]", fontsize=FONT)
    handles = [Line2D([], [], color=colour, label=name, linewidth=3) for name, colour in COLOURS.items()]
    handles += [Line2D([], [], color="black", linestyle=style, label=f"{points}² points", linewidth=2) for points, style in STYLES.items()]
    handles += [Line2D([], [], color=colour, linestyle=style, label=name, linewidth=3) for name, (colour, style) in ORDERS.items()]
    figure.legend(handles=handles, loc="center", bbox_to_anchor=(0.5, (BELOW - 1) / height), ncol=6, fontsize=FONT, frameon=False)
    text = "\n".join(textwrap.fill(f"{TITLES[name]}: {words}", 122) for name, words in sentences.items())
    figure.text(0.5, 0.2 / height, text, ha="center", va="bottom", fontsize=FONT)
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
        colour, style = COLOURS[line.scheme.transfer], STYLES[line.scheme.points_per_axis]
        axes.plot(line.seconds, line.errors, color=colour, linestyle=style, linewidth=1.6, marker=".", markersize=6)


def _draw_orders(axes: Axes, lines: Sequence[Line]) -> None:
    for order, (colour, style) in ORDERS.items():
        those = [line for line in lines if line.scheme.order == order]
        axes.plot(*_runs(those), ".", color=colour, markersize=5, alpha=0.35)
        axes.plot(*_front(those), color=colour, linestyle=style, linewidth=2.5)
