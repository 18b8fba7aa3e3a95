"""The picture of error against cost of material points: a panel for each problem."""

import textwrap
from collections.abc import Sequence
from pathlib import Path

import matplotlib.pyplot as plt
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.ticker import LogLocator, NullFormatter

from mpm_choice import Choice
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
FONT = 13


def draw(problems: dict[str, list[Line]], chosen: dict[str, Sequence[Choice]], sentences: dict[str, str], stem: Path) -> list[Path]:
    """Errors over CPU time, a line for each scheme through its meshes; what is worth its cost lies in the grey band."""
    figure, panels = plt.subplots(1, len(problems), figsize=(13, 8.5), squeeze=False)
    figure.subplots_adjust(left=0.075, right=0.985, top=0.93, bottom=0.4, wspace=0.28)
    for axes, (problem, lines) in zip(panels[0], problems.items()):
        _draw_lines(axes, lines)
        for choice in chosen[problem]:
            axes.plot(choice.seconds, choice.error, "o", markersize=13, markerfacecolor="none", color="black", markeredgewidth=2)
        axes.set_title(TITLES[problem], fontsize=16)
        axes.set_xlabel("CPU time [s]", fontsize=FONT)
        axes.set_ylabel(ERRORS[problem], fontsize=FONT)
    shapes = dict.fromkeys(line.scheme.shape for lines in problems.values() for line in lines)
    handles = [Line2D([], [], color=colour, label=name, linewidth=3) for name, colour in COLOURS.items()]
    handles += [Line2D([], [], color="black", linestyle=STYLES[name], label=name, linewidth=2) for name in shapes]
    figure.legend(handles=handles, loc="lower center", bbox_to_anchor=(0.5, 0.255), ncol=5, fontsize=FONT, frameon=False)
    text = "\n".join(textwrap.fill(f"{TITLES[name]}: {words}", 118) for name, words in sentences.items())
    figure.text(0.5, 0.125, text, ha="center", va="center", fontsize=14)
    return save(figure, stem)


def _draw_lines(axes: Axes, lines: Sequence[Line]) -> None:
    costs = [cost for line in lines for cost in line.seconds]
    errors = [error for line in lines for error in line.errors]
    front = pareto_front(costs, errors)
    axes.set(xscale="log", yscale="log")
    axes.plot([costs[i] for i in front], [errors[i] for i in front], color="0.85", linewidth=14, solid_capstyle="round", zorder=0)
    for line in lines:
        axes.plot(
            line.seconds,
            line.errors,
            color=COLOURS[line.scheme.transfer],
            linestyle=STYLES[line.scheme.shape],
            linewidth=1.4,
            marker={1: ".", 2: "s", 3: "^"}[line.scheme.points_per_axis],
            markersize=4,
        )
    axes.xaxis.set_major_locator(LogLocator(numticks=5))
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.tick_params(labelsize=FONT, which="both")
