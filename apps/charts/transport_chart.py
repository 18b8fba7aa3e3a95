"""The picture of error against cost of all schemes on one problem."""

import textwrap
from collections import Counter
from collections.abc import Collection, Sequence
from itertools import chain
from pathlib import Path
from typing import NamedTuple

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from pareto import pareto_front
from picture import WIDE, save, spread  # beside the plotting script, which transport_accuracy makes known
from transport_choice import Cost, evaluations, seconds
from transport_runs import MARKS, PLANES, TITLES, Line, Scheme

COLOURS = {  # by limiter, or by reconstruction where it has none: the same in all pictures, dark enough for paper
    "minmod(1)": "#7a5c99",
    "minmod(1.3)": "#1f5fa8",
    "minmod(2)": "#b3202c",
    "van_leer": "#0f8a6c",
    "superbee": "#c46a00",
    "van_albada": "#6b6b00",
    "piecewise_constant": "#1a1a1a",
    "cweno3": "#c2189b",
}
SPARE_COLOUR = "#008a9e"  # of limiters that came later
LINES = {"forward_euler": ":", "ssp_rk2": "-", "ssp_rk3": "--"}
LABEL_FONT = 14
LABEL_HEIGHT = 0.062  # [-], of a panel
SMALL_FONT = 13
SENTENCE_FONT = 17
MOST_NAMED = 6
FULL_LINE = 1570  # characters x font size
UNITS = {
    "sod": "L1 error of the density",
    "shu_osher": "L1 error of the density",
    "slotted_disk": "L1 error / area of the disk",
    "segregation_two_sizes": "L1 error of all fractions",
    "segregation_five_sizes": "L1 error of all fractions",
}
KEY = (
    "Grey band: runs that no other beats in both. Solid: RK2, dashed: RK3, dotted: Euler, dash-dotted: staggered. "
    "MC: minmod 2."
)


class Finding(NamedTuple):
    """What a picture says in words."""

    sentence: str
    remark: str
    chosen: Collection[Scheme]  # what the sentence names


def draw_chart(
    problem: str, lines: Sequence[Line], unfit: Collection[str], finding: Finding, stem: Path
) -> list[Path]:
    """Draws the errors over both costs, and writes PNG and SVG. The front is that of the fit integrators."""
    figure, panels = plt.subplots(1, 2, figsize=WIDE, sharey=True)
    figure.subplots_adjust(left=0.115, right=0.79, top=0.81, bottom=0.25, wspace=0.06)
    fit = [line for line in lines if line.scheme.integrator not in unfit]
    shown = _lines_on_fronts(fit, finding.chosen)
    for axes, cost in zip(panels, (seconds, evaluations)):
        axes.set(xscale="log", yscale="log")
        _draw_front(axes, fit, cost)
        _draw_lines(axes, lines, shown, cost)
    panels[0].set(xlabel="CPU time [s]", ylabel=UNITS.get(problem, "L1 error"))
    panels[1].set(xlabel="flux evaluations")
    for axes in panels:
        _draw_orders(axes, 3 if problem in PLANES else 2)
        axes.xaxis.set_major_locator(LogLocator(numticks=7))
    _name_errors(panels[0])
    _label_lines(panels[1], shown)
    figure.text(0.012, 0.975, TITLES.get(problem, problem), fontsize=20, fontweight="bold", va="top")
    is_long = len(finding.sentence) > 1.9 * FULL_LINE / SENTENCE_FONT
    _write(figure, 0.915, finding.sentence, SMALL_FONT if is_long else SENTENCE_FONT, "black")
    marks = [f"{mark} {meaning}." for mark, meaning in MARKS.items() if any(mark in line.label for line in shown)]
    _write(figure, 0.025, " ".join(filter(None, (finding.remark, KEY, *marks))), SMALL_FONT, "0.35")
    return save(figure, stem)


def _write(figure: plt.Figure, height: float, text: str, size: int, colour: str) -> None:
    """Lines that fill the picture's width, from a height in its upper half down, in its lower half up."""
    va = "top" if height > 0.5 else "bottom"
    lines = textwrap.fill(text, int(FULL_LINE / size))
    figure.text(0.012, height, lines, fontsize=size, color=colour, va=va, linespacing=1.25)


def _name_errors(axes: Axes) -> None:
    """Numbers beside the ticks; where the axis has hardly a decade, between the powers of ten too."""
    low, high = np.log10(axes.get_ylim())
    axes.yaxis.set_minor_formatter(NullFormatter())
    if high - low < 1.8:
        axes.yaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
        axes.yaxis.set_major_formatter(FuncFormatter(lambda error, _: f"{error:g}"))


def _lines_on_fronts(lines: Sequence[Line], chosen: Collection[Scheme]) -> list[Line]:
    """The chosen lines, and those with the most runs on the fronts of both costs; one alone may be chance."""
    runs = [(line, i) for line in lines for i in range(len(line.errors))]
    errors = [line.errors[i] for line, i in runs]
    counts: Counter[Scheme] = Counter()
    for cost in (seconds, evaluations):
        front = pareto_front([cost(line)[i] for line, i in runs], errors)
        counts.update(runs[run][0].scheme for run in front)
    often = [scheme for scheme, count in counts.most_common(MOST_NAMED) if count > 1]
    return [line for line in lines if line.scheme in chosen or line.scheme in often]


def _draw_front(axes: Axes, lines: Sequence[Line], cost: Cost) -> None:
    costs = list(chain.from_iterable(cost(line) for line in lines))
    errors = list(chain.from_iterable(line.errors for line in lines))
    front = pareto_front(costs, errors)
    x, y = [costs[run] for run in front], [errors[run] for run in front]
    axes.plot(x, y, color="0.87", linewidth=15, solid_capstyle="round", marker="o", markersize=15, zorder=0)


def _draw_lines(axes: Axes, lines: Sequence[Line], shown: Sequence[Line], cost: Cost) -> None:
    for line in lines:
        style = LINES.get(line.scheme.integrator, "-.")
        if line in shown:
            colour = _colour(line.scheme)
            axes.plot(cost(line), line.errors, style, color=colour, linewidth=2.4, marker="o", markersize=5)
        else:
            axes.plot(cost(line), line.errors, style, color="0.7", linewidth=0.8, zorder=1)


def _colour(scheme: Scheme) -> str:
    return COLOURS.get(scheme.limiter or scheme.scheme, SPARE_COLOUR)


def _draw_orders(axes: Axes, dimensions: int) -> None:
    """Thin lines with the slopes of orders 1 to 3, below the front; cost is cells^dimensions x steps."""
    low, high = np.log10(axes.get_xlim()), np.log10(axes.get_ylim())
    start = np.array([low[0] + 0.06 * (low[1] - low[0]), high[0] + 0.42 * (high[1] - high[0])])
    for order in (1, 2, 3):
        slope = -order / dimensions
        reach = min(0.2 * (low[1] - low[0]), 0.34 * (high[1] - high[0]) / -slope)
        end = start + reach * np.array([1, slope])
        axes.plot(*10 ** np.array([start, end]).T, color="0.55", linewidth=0.9, zorder=0)
        axes.annotate(f"{order}", 10**end, xytext=(3, -3), textcoords="offset points", fontsize=11, color="0.45")
    axes.annotate(
        "order", 10**start, xytext=(0, 4), textcoords="offset points", fontsize=11, color="0.45", ha="center"
    )
    axes.set(xlim=10**low, ylim=10**high)


def _label_lines(axes: Axes, lines: Sequence[Line]) -> None:
    """Names the lines to the right of the panel, the most accurate ones lowest."""
    low, high = np.log10(axes.get_ylim())
    right = np.log10(axes.get_xlim()[1])
    ends = [max(i for i, error in enumerate(line.errors) if np.isfinite(error)) for line in lines]
    heights = [np.log10(line.errors[end]) for line, end in zip(lines, ends)]
    margin = min(LABEL_HEIGHT, 1 / max(1, len(lines) - 1)) * (high - low)
    for line, end, place in zip(lines, ends, spread(heights, margin, low, high)):
        axes.annotate(
            line.label,
            xy=(line.evaluations[end], line.errors[end]),
            xytext=(1.05, (place - low) / (high - low)),
            textcoords="axes fraction",
            va="center",
            fontsize=LABEL_FONT,
            color=_colour(line.scheme),
            arrowprops={"arrowstyle": "-", "color": "0.75", "linewidth": 0.8, "shrinkB": 4, "relpos": (0, 0.5)},
            annotation_clip=False,
        )
