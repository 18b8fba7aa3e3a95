"""The Pareto front, the cost of an error, and the choice made from them, on runs that can be checked by hand."""

import math
import unittest

from pareto import cost_of_error, pareto_front
from transport_choice import choices, error_levels, evaluations, sentence, unfit_integrators
from transport_runs import Line, Scheme


def line(limiter: str, integrator: str, costs: tuple[float, ...], errors: tuple[float, ...]) -> Line:
    scheme = Scheme("piecewise_linear", "kurganov_tadmor", limiter, integrator)
    return Line(scheme, costs, costs, errors, tuple(10 * 2**i for i in range(len(errors))))


class ParetoFront(unittest.TestCase):
    def test_is_what_no_run_beats_in_both(self) -> None:
        costs = [1, 2, 3, 4, 5]
        errors = [9, 5, 7, 5, 1]  # run 2 is beaten by run 1, run 3 is no better than run 1

        self.assertEqual(pareto_front(costs, errors, slack=0), [0, 1, 4])

    def test_leaves_out_what_a_hardly_dearer_run_beats(self) -> None:
        self.assertEqual(pareto_front([1, 1.05, 1.2], [9, 8, 7], slack=0.1), [1, 2])

    def test_takes_the_more_accurate_of_two_runs_of_the_same_cost(self) -> None:
        self.assertEqual(pareto_front([1, 1], [9, 8], slack=0), [1])

    def test_ignores_runs_that_failed(self) -> None:
        self.assertEqual(pareto_front([1, math.nan, 2], [math.nan, 1, 3], slack=0), [2])

    def test_of_nothing_is_nothing(self) -> None:
        self.assertEqual(pareto_front([], []), [])


class CostOfError(unittest.TestCase):
    costs = (1.0, 4.0, 16.0)
    errors = (1.0, 0.25, 0.0625)  # error = 1/cost

    def test_lies_between_two_runs_on_a_power_law(self) -> None:
        self.assertAlmostEqual(cost_of_error(self.costs, self.errors, 0.125), 8)

    def test_is_that_of_a_run_at_its_own_error(self) -> None:
        self.assertAlmostEqual(cost_of_error(self.costs, self.errors, 0.25), 4)

    def test_is_that_of_the_coarsest_run_where_this_is_good_enough(self) -> None:
        self.assertEqual(cost_of_error(self.costs, self.errors, 2), 1)

    def test_is_infinite_below_the_finest(self) -> None:
        self.assertEqual(cost_of_error(self.costs, self.errors, 0.06), math.inf)

    def test_is_infinite_where_the_finest_run_failed(self) -> None:
        self.assertEqual(cost_of_error(self.costs, (1.0, 0.25, math.nan), 0.3), math.inf)

    def test_counts_from_where_all_finer_runs_are_good_enough(self) -> None:
        self.assertEqual(cost_of_error(self.costs, (0.2, 0.8, 0.2), 0.2), 16)


class ChoiceOfScheme(unittest.TestCase):
    first = line("minmod(1.3)", "ssp_rk2", (1, 10, 100), (1, 0.1, 0.01))  # error = 1/cost
    second = line("minmod(2)", "ssp_rk2", (5, 50, 500), (0.5, 0.005, 0.00005))  # 12.5/cost^2

    def test_takes_three_errors_from_the_best_runs(self) -> None:
        # 0.5, half as much again as 0.00005 rounded up, and their mean in logarithms, 0.0061
        self.assertEqual(error_levels([self.first, self.second]), [0.5, 0.006, 8e-5])

    def test_is_the_cheapest_at_each_error(self) -> None:
        made = choices([self.first, self.second], [], evaluations)

        self.assertEqual([choice.line for choice in made], [self.first, self.second, self.second])
        self.assertAlmostEqual(made[0].cost, 2)
        self.assertAlmostEqual(made[1].cost, math.sqrt(12.5 / 0.006))
        self.assertEqual(
            sentence(made),
            "Choose minmod 1.3 with RK2 and KT for an error of 0.5; MC with RK2 and KT for 0.006 to 8e-05.",
        )

    def test_stays_with_a_scheme_whose_cost_is_equal_within_a_tenth(self) -> None:
        near = line("van_leer", "ssp_rk2", (1.05, 10.5, 95), (1, 0.1, 0.01))

        made = choices([self.first, near], [], evaluations)

        self.assertEqual({choice.line for choice in made}, {self.first})

    def test_says_what_the_default_costs(self) -> None:
        better = line("minmod(2)", "ssp_rk2", (1, 10, 100), (0.5, 0.05, 0.005))  # half the error for the same cost
        # The smallest error, 0.008, is below the default's 0.01; the middle one is sqrt(0.5 x 0.0075).

        made = choices([self.first, better], [], evaluations)

        self.assertTrue(sentence(made).endswith("The default costs 2 times as much at 0.06."), sentence(made))

    def test_leaves_out_an_integrator_that_fails_a_problem_with_every_limiter(self) -> None:
        cheap = line("minmod(1)", "forward_euler", (0.1, 1, 10), (1, 0.1, 0.01))
        stuck = line("minmod(1)", "forward_euler", (0.1, 1, 10), (1, 0.9, 0.8))
        problems = {"sod": [self.first, cheap], "advection": [self.first, stuck]}

        unfit = unfit_integrators(problems)
        made = choices(problems["sod"], unfit, evaluations)

        self.assertEqual(unfit, {"forward_euler": ["advection"]})
        self.assertEqual({choice.line for choice in made}, {self.first})


if __name__ == "__main__":
    unittest.main()
