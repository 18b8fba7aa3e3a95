"""Which runs are worth their cost: the Pareto front, and the cost at which a scheme reaches an error."""

import math
from collections.abc import Sequence


EQUAL_COSTS = 0.1  # [-]: CPU times repeat to a tenth or so


def pareto_front(costs: Sequence[float], errors: Sequence[float], slack: float = EQUAL_COSTS) -> list[int]:
    """The runs that no other run beats in both cost and error, by rising cost; NaN beats nothing.

    One that is beaten in error at up to `slack` of its cost more is not on the front either.
    """
    front: list[int] = []
    for run in sorted(range(len(costs)), key=lambda each: (costs[each], errors[each])):
        if not (math.isfinite(costs[run]) and math.isfinite(errors[run])):
            continue
        if front and not errors[run] < errors[front[-1]]:
            continue
        while front and costs[run] <= (1 + slack) * costs[front[-1]]:
            front.pop()
        front.append(run)
    return front


def cost_of_error(costs: Sequence[float], errors: Sequence[float], wanted: float) -> float:
    """The cost from which on a scheme's error is at most `wanted`, between its runs along straight lines in
    logarithms. Inf if it does not get there; that of its coarsest run where this one is good enough already.
    """
    if not errors or not errors[-1] <= wanted:
        return math.inf
    last = len(errors) - 1  # the first run from which on all are good enough
    while last > 0 and errors[last - 1] <= wanted:
        last -= 1
    if last == 0 or not math.isfinite(errors[last - 1]):
        return costs[last]
    part = math.log(errors[last - 1] / wanted) / math.log(errors[last - 1] / errors[last])
    return costs[last - 1] * (costs[last] / costs[last - 1]) ** part
