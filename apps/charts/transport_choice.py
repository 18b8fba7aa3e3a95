"""What to choose: the scheme that reaches an error at the least cost, and in words."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from pareto import cost_of_error
from transport_runs import INTEGRATORS, TITLES, Line, Scheme

Lines = dict[str, list[Line]]  # by problem
Cost = Callable[[Line], Sequence[float]]
USUAL = Scheme("piecewise_linear", "kurganov_tadmor", "minmod(1)", "ssp_rk2")  # what the library does untold
USUAL_FRACTIONS = Scheme("piecewise_linear_common", "kurganov_tadmor", "minmod(1)", "ssp_rk2")


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


def error_levels(lines: Sequence[Line]) -> tuple[float, float, float]:
    """Three errors, of one digit: what the best scheme has on the coarsest grid, on the finest, and between."""
    coarse = min(line.errors[0] for line in lines if math.isfinite(line.errors[0]))
    fine = min(line.errors[-1] for line in lines if math.isfinite(line.errors[-1]))
    return tuple(map(_one_digit_up, (coarse, math.sqrt(coarse * fine), fine)))  # type: ignore[return-value]


def _one_digit_up(number: float) -> float:
    unit = 10 ** math.floor(math.log10(number))
    return float(f"{math.ceil(number / unit - 1e-9) * unit:.1g}")


def unfit_integrators(problems: Lines) -> dict[str, list[str]]:
    """The integrators with which no scheme reaches the middle error of some problem, and those problems."""
    unfit: dict[str, list[str]] = {}
    for problem, lines in problems.items():
        middle = error_levels(lines)[1]
        fit = {line.scheme.integrator for line in lines if math.isfinite(_cost(line, evaluations, middle))}
        for integrator in {line.scheme.integrator for line in lines} - fit:
            unfit.setdefault(integrator, []).append(problem)
    return unfit


def choices(lines: Sequence[Line], unfit: Sequence[str], cost: Cost) -> list[Choice]:
    """The cheapest scheme at each of the three errors, of those with a fit integrator."""
    usual = next((line for line in lines if line.scheme in (USUAL, USUAL_FRACTIONS)), None)
    result = []
    for error in error_levels(lines):
        fit = [line for line in lines if line.scheme.integrator not in unfit]
        best = min(fit, key=lambda line: _cost(line, cost, error), default=None)
        if best is not None and math.isfinite(_cost(best, cost, error)):
            usual_cost = _cost(usual, cost, error) if usual else math.nan
            result.append(Choice(error, best, _cost(best, cost, error), usual_cost))
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
    parts = [f"{run[0].line.scheme.label} {_span(run)}" for run in runs]
    return f"Choose {', '.join(parts)}{_saving(made)}."


def _span(run: Sequence[Choice]) -> str:
    if len(run) == 1:
        return f"for an error of {run[0].error:g}"
    return f"for errors of {run[0].error:g} to {run[-1].error:g}"


def _saving(made: Sequence[Choice]) -> str:
    """How many times the cost of the choice the usual scheme has, at the smallest error that it reaches."""
    for choice in reversed(made):
        if choice.line.scheme in (USUAL, USUAL_FRACTIONS):
            continue
        if math.isfinite(choice.usual_cost):
            factor = choice.usual_cost / choice.cost
            return f"; the default takes {factor:.2g} times as long at {choice.error:g}"
    return ""


def warning(made: Sequence[Choice], problems: Lines, unfit: dict[str, list[str]]) -> str:
    """The problems in which a choice of these does not reach the middle error, and the integrators left out."""
    parts = []
    for limiter in dict.fromkeys(choice.line.scheme.limiter for choice in made):
        scheme = next(choice.line.scheme for choice in made if choice.line.scheme.limiter == limiter)
        missed = [TITLES[problem] for problem, lines in problems.items() if _misses(lines, limiter, scheme.integrator)]
        if missed:
            parts.append(f"{scheme.label.split(',')[0]} falls behind in: {'; '.join(missed)}")
    for integrator, missed in unfit.items():
        name = INTEGRATORS.get(integrator, integrator)
        parts.append(f"{name} left out: poor in {', '.join(TITLES[problem] for problem in missed)}")
    return ". ".join(parts)


def _misses(lines: Sequence[Line], limiter: str, integrator: str) -> bool:
    middle = error_levels(lines)[1]
    mine = [line for line in lines if (line.scheme.limiter, line.scheme.integrator) == (limiter, integrator)]
    return bool(mine) and not any(math.isfinite(_cost(line, evaluations, middle)) for line in mine)
