"""The pictures of error against cost: of a layer, with the crossovers, and of points."""

import textwrap
from collections.abc import Sequence
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator, NullFormatter

from pareto import pareto_front
from picture import save, spread  # beside the plotting script, which rheology_accuracy makes known
from rheology_choice import Comparison, Cost, Range, crossover, number
from rheology_runs import METHODS, PARAMETERS, TITLES, Line, seconds

COLOURS = {
    "explicit": "#1a1a1a",
    "rkl2": "#1f5fa8",
    "implicit": "#0f8a6c",
    "two_solves": "#b3202c",
    "closed_return": "#1f5fa8",
    "cvode": "#c46a00",
}
FONT = 13
SENTENCE_FONT = 16
TALL = (12, 10)  # [inch]


def draw_layer(
    problem: str,
    parameters: dict[float, list[Line]],
    by_cost: dict[str, tuple[Sequence[Comparison], Sequence[Range]]],
    sentence: str,
    stem: Path,
) -> list[Path]:
    """Above, errors over CPU time for each parameter; below, costs at equal error over the ratio of steps."""
    figure = plt.figure(figsize=TALL)
    figure.suptitle(f"{TITLES[problem]} down a slope, 51 nodes", fontsize=18)
    above = figure.add_gridspec(1, len(parameters), left=0.085, right=0.86, top=0.89, bottom=0.61, wspace=0.1)
    below = figure.add_gridspec(1, 2, left=0.085, right=0.86, top=0.5, bottom=0.19, wspace=0.08)
    panels = above.subplots(sharey=True)
    for axes, (parameter, lines) in zip(panels, parameters.items()):
        _draw_errors(axes, lines)
        axes.set_title(PARAMETERS[problem].format(f"{parameter:g}"), fontsize=FONT)
    panels[0].set_ylabel("error of the velocity", fontsize=FONT)
    panels[len(panels) // 2].set_xlabel("CPU time [s]", fontsize=FONT)
    _label(panels[-1], [(line.method, line.errors[-1]) for line in lines])
    costs = below.subplots(sharey=True)
    for axes, (name, (compared, chosen)) in zip(costs, by_cost.items()):
        _draw_costs(axes, compared, chosen)
        axes.set_title(name, fontsize=FONT)
    costs[0].set_ylabel("cost / that of explicit steps,\nat equal error", fontsize=FONT)
    figure.text(0.47, 0.125, "step of backward Euler for that error / explicit viscous limit", fontsize=FONT, ha="center")
    longest = max((each for each in compared), key=lambda each: each.ratio)
    _label(costs[1], [(name, cost) for name, cost in longest.costs.items()])
    _write(figure, sentence, 0.06)
    return save(figure, stem)


def draw_points(problems: dict[str, list[Line]], sentences: dict[str, str], cost: Cost, stem: Path) -> list[Path]:
    """Errors over CPU time of a path, a panel for each law; first order as a thin line."""
    figure, panels = plt.subplots(1, len(problems), figsize=(12, 6.75), sharey=True)
    figure.subplots_adjust(left=0.095, right=0.97, top=0.9, bottom=0.29, wspace=0.08)
    for axes, (problem, lines) in zip(panels, problems.items()):
        _draw_errors(axes, lines)
        axes.set_title(TITLES[problem], fontsize=16)
        axes.set_xlabel("CPU time of a path [s]", fontsize=FONT)
        for line, place, offset, side in zip(lines, (2, -1), ((10, 8), (-10, 0)), ("left", "right")):
            at = (cost(line)[place], line.errors[place])
            colour = COLOURS[line.method]
            axes.annotate(METHODS[line.method], at, offset, textcoords="offset points", color=colour, ha=side)
        error = crossover(lines, cost)
        axes.axhline(error, color="0.5", linewidth=1.2, linestyle="--", zorder=0)
        axes.annotate(f"{error:.1g}", (0.01, error), (0, 4), ("axes fraction", "data"), "offset points", color="0.3")
        x = np.array([cost(lines[0])[-4], cost(lines[0])[-1]])
        axes.plot(x, 0.4 * lines[0].errors[-4] * x[0] / x, color="0.55", linewidth=0.9)
        axes.text(x[0], 0.25 * lines[0].errors[-4], "order 1", color="0.45", fontsize=FONT, ha="right")
    panels[0].set_ylabel("error of the stress", fontsize=FONT)
    _write(figure, " ".join(f"{TITLES[problem]}: {sentence}" for problem, sentence in sentences.items()), 0.1)
    return save(figure, stem)


def _draw_errors(axes: Axes, lines: Sequence[Line]) -> None:
    costs = [cost for line in lines for cost in seconds(line)]
    errors = [error for line in lines for error in line.errors]
    front = pareto_front(costs, errors)
    axes.set(xscale="log", yscale="log")
    x, y = [costs[run] for run in front], [errors[run] for run in front]
    axes.plot(x, y, color="0.87", linewidth=12, solid_capstyle="round", zorder=0)
    for line in lines:
        axes.plot(seconds(line), line.errors, color=COLOURS[line.method], linewidth=2, marker="o", markersize=3.5)
    _tidy(axes, 4)


def _draw_costs(axes: Axes, compared: Sequence[Comparison], chosen: Sequence[Range]) -> None:
    axes.set(xscale="log", yscale="log")
    for parameter in dict.fromkeys(each.parameter for each in compared):
        mine = [each for each in compared if each.parameter == parameter]
        for method in mine[0].costs:
            ratios, costs = [each.ratio for each in mine], [each.costs[method] for each in mine]
            axes.plot(ratios, costs, color=COLOURS[method], linewidth=1.6, marker="o", markersize=3)
    for before, after in zip(chosen, chosen[1:]):
        axes.axvline(after.low, color="0.5", linewidth=1.2, linestyle="--", zorder=0)
        axes.text(
            after.low, 1.0, f" {number(after.low)}", transform=axes.get_xaxis_transform(), va="top", fontsize=FONT, color="0.3"
        )
    _tidy(axes, 6)


def _tidy(axes: Axes, most_ticks: int) -> None:
    axes.xaxis.set_major_locator(LogLocator(numticks=most_ticks))
    axes.yaxis.set_major_locator(LogLocator(numticks=8))
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.tick_params(labelsize=FONT, which="both")


def _label(axes: Axes, ends: Sequence[tuple[str, float]]) -> None:
    """Names methods to the right of a panel, as near to their heights as they fit."""
    low, high = np.log10(axes.get_ylim())
    heights = [np.log10(height) if np.isfinite(height) else high for _, height in ends]
    for (method, _), place in zip(ends, spread(heights, 0.12 * (high - low), low, high)):
        axes.text(
            1.04,
            (place - low) / (high - low),
            METHODS[method],
            transform=axes.transAxes,
            color=COLOURS[method],
            va="center",
            fontsize=FONT,
        )


def _write(figure: Figure, sentence: str, place: float) -> None:
    figure.text(0.5, place, textwrap.fill(sentence, 100), ha="center", va="center", fontsize=SENTENCE_FONT, color="black")
