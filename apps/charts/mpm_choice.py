"""What to choose for material points: the scheme that reaches an error at the least cost, and in words."""

import math
from collections.abc import Sequence
from dataclasses import astuple
from typing import NamedTuple

from mpm_runs import Line, Scheme
from pareto import cost_of_error

USUAL = Scheme("quadratic", "apic", "usl", 2)
EQUAL_COSTS = 0.25  # [-]: single runs on a shared machine repeat to a fifth, up or down, nine times out of ten


class Choice(NamedTuple):
    """The cheapest scheme at an error, and what quadratic splines with APIC on 2² points cost there."""

    error: float
    scheme: Scheme
    seconds: float
    reached: float  # its error at that cost: less than asked for where that is the cost of a run with less
    usual_seconds: float  # inf where they do not get there
    order_seconds: dict[str, float]  # the best of each order of the step; inf likewise


def error_levels(lines: Sequence[Line]) -> list[float]:
    """Two errors of one digit: what the best scheme makes of the coarsest mesh, rounded up, and half as much again as
    the best on the finest."""
    coarse = min(line.errors[0] for line in lines if math.isfinite(line.errors[0]))
    fine = 1.5 * min(line.errors[-1] for line in lines if math.isfinite(line.errors[-1]))
    return sorted({_rounded_up(coarse), _rounded_up(fine)}, reverse=True)


def _rounded_up(error: float) -> float:
    unit = 10 ** math.floor(math.log10(error))
    return float(f"{math.ceil(error / unit) * unit:.1g}")


def choices(lines: Sequence[Line]) -> list[Choice]:
    """The cheapest scheme at each error. Where costs are equal to their repeatability, the usual scheme, or else that
    of the error before, or else the one most like the usual is the choice."""
    result: list[Choice] = []
    for error in error_levels(lines):
        costs = {line.scheme: cost_of_error(line.seconds, line.errors, error) for line in lines}
        least = min(costs.values())
        if not math.isfinite(least):
            continue
        near = [scheme for scheme, cost in costs.items() if cost <= (1 + EQUAL_COSTS) * least]
        preferred = [USUAL, *(choice.scheme for choice in reversed(result))]
        alike = min(near, key=lambda scheme: (_differences(scheme, USUAL), costs[scheme]))
        best = next((scheme for scheme in preferred if scheme in near), alike)
        line_of_best = next(line for line in lines if line.scheme == best)
        reached = dict(zip(line_of_best.seconds, line_of_best.errors)).get(costs[best], error)
        result.append(Choice(error, best, costs[best], reached, costs.get(USUAL, math.inf), _best_of_orders(costs)))
    return result


def _differences(one: Scheme, other: Scheme) -> int:
    return sum(a != b for a, b in zip(astuple(one), astuple(other)))


def _best_of_orders(costs: dict[Scheme, float]) -> dict[str, float]:
    best: dict[str, float] = {}
    for scheme, cost in costs.items():
        best[scheme.order] = min(cost, best.get(scheme.order, math.inf))
    return best


def sentence(chosen: Sequence[Choice]) -> str:
    """What to choose, in one sentence for each error, and one on the order of the step."""
    parts = []
    for choice in chosen:
        factor = choice.usual_seconds / choice.seconds
        beside = ""
        if choice.scheme != USUAL:
            beside = f" ({USUAL} takes {factor:.1f} times as long)" if math.isfinite(factor) else f" ({USUAL} does not get there)"
        parts.append(f"For an error of {choice.error:g} choose {choice.scheme}{beside}.")
    orders = [_order_beside_usl(order, chosen) for order in ("musl", "usf")]
    if all(orders):
        parts.append(f"Beside the best of usl, that of {orders[0]}, of {orders[1]}.")
    return " ".join(parts)


def _order_beside_usl(order: str, chosen: Sequence[Choice]) -> str:
    """How many times as long the best of an order takes as that of usl; empty where either was not run."""
    if not all({order, "usl"} <= choice.order_seconds.keys() for choice in chosen):
        return ""
    factors = [choice.order_seconds[order] / choice.order_seconds["usl"] for choice in chosen]
    if not all(math.isfinite(factor) for factor in factors):
        return f"{order} does not get to every error"
    least, most = f"{min(factors):.1f}", f"{max(factors):.1f}"
    return f"{order} takes {least if least == most else f'{least} to {most}'} times as long"
