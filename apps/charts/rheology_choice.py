"""What to choose: the method that is cheapest at equal error, over how stiff the problem is, and in words."""

import math
from collections.abc import Callable, Iterable, Sequence
from typing import NamedTuple

from pareto import EQUAL_COSTS, cost_of_error
from rheology_runs import METHODS, Line

Cost = Callable[[Line], Sequence[float]]
BIN = 0.5  # decades
USEFUL = 0.05  # [-]: larger errors are no start-up


class Comparison(NamedTuple):
    """What each method costs to be as right as backward Euler is with a step, beside explicit steps."""

    parameter: float
    ratio: float  # of that step to the longest stable explicit one
    costs: dict[str, float]  # by method, over that of explicit steps; inf where it does not get there


class Range(NamedTuple):
    """Ratios of steps for which a method is the cheapest."""

    method: str
    low: float
    high: float


def comparisons(parameters: dict[float, list[Line]], cost: Cost) -> list[Comparison]:
    """One for each run of backward Euler whose error is small enough to be of use."""
    result = []
    for parameter, lines in parameters.items():
        wanted = next(line for line in lines if line.method == "implicit")
        for ratio, error in zip(wanted.ratio, wanted.errors):
            costs = {line.method: cost_of_error(cost(line), line.errors, error) for line in lines}
            unit = costs.get("explicit", math.inf)
            if error <= USEFUL and math.isfinite(unit):
                result.append(Comparison(parameter, ratio, {name: each / unit for name, each in costs.items()}))
    return result


def ranges(compared: Sequence[Comparison]) -> list[Range]:
    """The cheapest method in each half decade of ratios: by the mean in logarithms over all parameters. Neighbours
    with the same are joined; within a tenth that of the half decade before stays."""
    bins: dict[int, list[Comparison]] = {}
    for each in compared:
        bins.setdefault(math.floor(math.log10(each.ratio) / BIN + 1e-9), []).append(each)
    result: list[Range] = []
    for number in sorted(bins):
        costs = {name: _mean(each.costs[name] for each in bins[number]) for name in bins[number][0].costs}
        best = min(costs, key=lambda name: costs[name])
        if result and costs[result[-1].method] <= (1 + EQUAL_COSTS) * costs[best]:
            best = result[-1].method
        low, high = 10 ** (number * BIN), 10 ** ((number + 1) * BIN)
        if result and result[-1].method == best:
            low = result.pop().low
        result.append(Range(best, low, high))
    return result


def _mean(costs: Iterable[float]) -> float:
    logarithms = [math.log(cost) if cost < math.inf else math.inf for cost in costs]
    return math.exp(sum(logarithms) / len(logarithms)) if math.isfinite(sum(logarithms)) else math.inf


def number(value: float) -> str:
    """Two digits, without a power of ten up to a million."""
    return f"{float(f'{value:.2g}'):.0f}" if 10 <= value < 1e6 else f"{value:.2g}"


def layer_sentence(chosen: Sequence[Range]) -> str:
    """What to choose for a layer."""
    parts = [f"{METHODS[chosen[0].method]} up to a ratio of {number(chosen[0].high)}"] if len(chosen) > 1 else []
    parts += [f"{METHODS[each.method]} up to {number(each.high)}" for each in chosen[1:-1]]
    last = METHODS[chosen[-1].method]
    parts.append(f"{last} above" if len(chosen) > 1 else f"{last} throughout")
    return f"Choose {'; '.join(parts)}."


def saving(compared: Sequence[Comparison], chosen: Sequence[Range]) -> str:
    """How many times as much as the last choice explicit steps cost, at most."""
    method = chosen[-1].method
    best = max(compared, key=lambda each: 1 / each.costs[method])
    factor = 1 / best.costs[method]
    return f"Explicit steps cost up to {number(factor)} times as much, at a ratio of {number(best.ratio)}."


def crossover(lines: Sequence[Line], cost: Cost) -> float:
    """The error below which CVODE is cheaper than the closed return, to the runs of the latter; 0: nowhere."""
    closed = next(line for line in lines if line.method == "closed_return")
    cvode = next(line for line in lines if line.method == "cvode")
    cheaper = [
        error
        for spent, error in zip(cost(closed), closed.errors)
        if cost_of_error(cost(cvode), cvode.errors, error) < spent
    ]
    return max(cheaper, default=0)


def point_sentence(lines: Sequence[Line], cost: Cost) -> str:
    """What to choose at a point."""
    error = crossover(lines, cost)
    if error == 0:
        return "Choose the closed return throughout."
    return f"Choose the closed return down to an error of {error:.1g}; CVODE below."
