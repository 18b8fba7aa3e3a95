"""What to choose: the scheme that reaches an error at the least cost, and in words."""

import math
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass

from pareto import EQUAL_COSTS, cost_of_error
from transport_runs import INTEGRATORS, NAMES, Line, Scheme

Lines = dict[str, list[Line]]  # by problem
Cost = Callable[[Line], Sequence[float]]
USUAL = (  # what the library does untold, for a gas, for a scalar and for fractions
    Scheme("primitive", "kurganov_noelle_petrova", "minmod(1.3)", "ssp_rk2"),
    Scheme("piecewise_linear", "kurganov_tadmor", "minmod(1.3)", "ssp_rk2"),
    Scheme("piecewise_linear_common", "kurganov_tadmor", "minmod(1)", "ssp_rk2"),
)


@dataclass(frozen=True)
class Choice:
    """The cheapest scheme at an error, and what the usual one costs there."""

    error: float
    line: Line
    cost: float
    usual_cost: float  # inf where the usual scheme does not get there, NaN where it was not run


def seconds(line: Line) -> Sequence[float]:
    return line.seconds


def evaluations(line: Line) -> Sequence[float]:
    return line.evaluations


def error_levels(lines: Sequence[Line]) -> list[float]:
    """Three errors of one digit: just below the best on the coarsest grid, where most schemes have to refine; half
    as much again as the best on the finest, where several get to; and between."""
    coarse = min(line.errors[0] for line in lines if math.isfinite(line.errors[0]))
    fine = 1.5 * min(line.errors[-1] for line in lines if math.isfinite(line.errors[-1]))
    levels = (coarse, math.floor), (math.sqrt(coarse * fine), round), (fine, math.ceil)
    return sorted((_one_digit(*level) for level in levels), reverse=True)


def _one_digit(number: float, rounded: Callable[[float], int]) -> float:
    unit = 10 ** math.floor(math.log10(number))
    return float(f"{rounded(number / unit) * unit:.1g}")


def unfit_integrators(problems: Lines) -> dict[str, list[str]]:
    """The integrators with which no scheme reaches the middle error of some problem, and those problems."""
    unfit: dict[str, list[str]] = {}
    for problem, lines in problems.items():
        middle = error_levels(lines)[1]
        fit = {line.scheme.integrator for line in lines if math.isfinite(_cost(line, evaluations, middle))}
        for integrator in {line.scheme.integrator for line in lines if line.scheme.integrator} - fit:
            unfit.setdefault(integrator, []).append(problem)
    return unfit


def choices(lines: Sequence[Line], unfit: Collection[str], cost: Cost) -> list[Choice]:
    """The cheapest scheme at each of the three errors, of those with a fit integrator. Where costs are equal to
    their repeatability, the scheme of the error before stays."""
    usual = next((line for scheme in USUAL for line in lines if line.scheme == scheme), None)
    fit = [line for line in lines if line.scheme.integrator not in unfit]
    result: list[Choice] = []
    for error in error_levels(lines):
        costs = {line.scheme: _cost(line, cost, error) for line in fit}
        least = min(costs.values(), default=math.inf)
        if not math.isfinite(least):
            continue
        near = [line for line in fit if costs[line.scheme] <= (1 + EQUAL_COSTS) * least]
        best = min(near, key=lambda line: costs[line.scheme])
        line = result[-1].line if result and result[-1].line in near else best
        result.append(Choice(error, line, costs[line.scheme], _cost(usual, cost, error) if usual else math.nan))
    return result


def _cost(line: Line, cost: Cost, error: float) -> float:
    return cost_of_error(cost(line), line.errors, error)


def sentence(made: Sequence[Choice]) -> str:
    """What to choose, and what it saves."""
    runs: list[list[Choice]] = []  # neighbouring errors with the same choice
    for choice in made:
        if runs and runs[-1][-1].line is choice.line:
            runs[-1].append(choice)
        else:
            runs.append([choice])
    first, *others = (f"{_in_words(run[0].line)} for {{}}{_span(run)}" for run in runs)
    unit = "an error of " if runs[0][0].error == runs[0][-1].error else "errors of "
    return f"Choose {'; '.join([first.format(unit), *(other.format('') for other in others)])}.{_saving(made)}"


def _in_words(line: Line) -> str:
    kind, *others = line.parts
    return f"{kind} with {' and '.join(others)}" if others else kind


def _span(run: Sequence[Choice]) -> str:
    if run[0].error == run[-1].error:
        return f"{run[0].error:g}"
    return f"{run[0].error:g} to {run[-1].error:g}"


def _saving(made: Sequence[Choice]) -> str:
    """How many times the cost of the choice the usual scheme has, at the smallest error that it reaches."""
    for choice in reversed(made):
        if math.isfinite(choice.usual_cost) and choice.usual_cost > (1 + EQUAL_COSTS) * choice.cost:
            factor = choice.usual_cost / choice.cost
            return f" The default costs {factor:.2g} times as much at {choice.error:g}."
    return ""


def warning(made: Sequence[Choice], problems: Lines, unfit: dict[str, list[str]]) -> str:
    """Where the choice does badly, and which integrators were left out for what."""
    parts = []
    for line in {_family(choice.line.scheme): choice.line for choice in made}.values():
        missed = [problem for problem, lines in problems.items() if _misses(lines, line.scheme)]
        if missed:
            parts.append(f"{line.parts[0]} falls behind in {_list_of(missed)}.")
    for integrator, missed in unfit.items():
        name = INTEGRATORS.get(integrator, integrator)
        parts.append(f"{name} (grey) is left out: with any limiter it fails in {_list_of(missed)}.")
    return " ".join(part[0].upper() + part[1:] for part in dict.fromkeys(parts))


def _list_of(problems: Sequence[str]) -> str:
    return ", ".join(NAMES.get(problem, problem) for problem in problems)


def _family(scheme: Scheme) -> tuple[str, str]:
    """What schemes for a scalar, a system and fractions have in common: limiter, if any, and integrator."""
    return scheme.limiter or scheme.scheme, scheme.integrator


def _misses(lines: Sequence[Line], scheme: Scheme) -> bool:
    """Whether no scheme of the same family reaches the middle error."""
    middle = error_levels(lines)[1]
    mine = [line for line in lines if _family(line.scheme) == _family(scheme)]
    return bool(mine) and not any(math.isfinite(_cost(line, evaluations, middle)) for line in mine)
