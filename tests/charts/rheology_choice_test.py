"""The choice between the methods of stiff rheology, from runs that can be checked by hand."""

import math
import unittest

from rheology_choice import comparisons, crossover, layer_sentence, number, point_sentence, ranges, saving
from rheology_runs import Line, seconds


def line(method: str, costs: tuple[float, ...], errors: tuple[float, ...], ratios: tuple[float, ...] = ()) -> Line:
    steps = tuple(2.0**i for i in range(len(costs)))
    return Line(method, 1.0, steps, ratios or (0.0,) * len(costs), costs, costs, errors)


class ChoiceForALayer(unittest.TestCase):
    # Explicit steps of the limit cost 1000 and have an error below all that are asked for; one solve costs 20.
    explicit = line("explicit", (1000.0,), (1e-6,), (1.0,))
    implicit = line("implicit", (2000.0, 20000.0), (0.04, 0.004), (10.0, 1.0))
    rkl2 = line("rkl2", (100.0, 200.0), (0.04, 0.004), (10.0, 1.0))

    def test_compares_costs_at_the_errors_of_backward_euler(self) -> None:
        compared = comparisons({1.0: [self.explicit, self.implicit, self.rkl2]}, seconds)

        self.assertEqual([each.ratio for each in compared], [10, 1])
        self.assertEqual(compared[0].costs, {"explicit": 1, "implicit": 2, "rkl2": 0.1})
        self.assertEqual(compared[1].costs, {"explicit": 1, "implicit": 20, "rkl2": 0.2})

    def test_leaves_out_errors_that_are_no_use(self) -> None:
        useless = line("implicit", (10.0, 2000.0), (0.06, 0.04), (20.0, 10.0))

        self.assertEqual([each.ratio for each in comparisons({1.0: [self.explicit, useless]}, seconds)], [10])

    def test_leaves_out_a_parameter_whose_explicit_steps_cannot_be_paid_for(self) -> None:
        self.assertEqual(comparisons({1.0: [self.implicit, self.rkl2]}, seconds), [])

    def test_is_the_cheapest_in_each_half_decade(self) -> None:
        implicit = line("implicit", (20.0, 60.0, 200.0, 2000.0), (0.04, 0.03, 0.02, 0.001), (1000, 300, 50, 1))
        rkl2 = line("rkl2", (150.0, 160.0, 300.0), (0.04, 0.02, 0.001), (1000, 50, 1))

        chosen = ranges(comparisons({1.0: [self.explicit, implicit, rkl2]}, seconds))

        self.assertEqual([each.method for each in chosen], ["rkl2", "implicit"])
        self.assertAlmostEqual(chosen[1].low, 100)  # 300 lies in the half decade from 100 on
        self.assertEqual(layer_sentence(chosen), "Choose RKL2 up to a ratio of 100; backward Euler above.")

    def test_says_what_explicit_steps_cost(self) -> None:
        compared = comparisons({1.0: [self.explicit, self.implicit, self.rkl2]}, seconds)

        self.assertEqual(
            saving(compared, ranges(compared)), "Explicit steps cost up to 10 times as much, at a ratio of 10."
        )

    def test_writes_numbers_without_powers_where_they_are_short(self) -> None:
        self.assertEqual([number(x) for x in (0.316, 3162.3, 1e6)], ["0.32", "3200", "1e+06"])


class ChoiceAtAPoint(unittest.TestCase):
    closed = line("closed_return", (1.0, 10.0, 100.0), (0.1, 0.01, 0.001))

    def test_crosses_over_where_cvode_is_cheaper_at_the_same_error(self) -> None:
        cvode = line("cvode", (20.0, 40.0), (0.01, 1e-6))

        self.assertEqual(crossover([self.closed, cvode], seconds), 0.001)
        self.assertEqual(
            point_sentence([self.closed, cvode], seconds),
            "Choose the closed return down to an error of 0.001; CVODE below.",
        )

    def test_is_the_closed_return_where_cvode_never_pays(self) -> None:
        cvode = line("cvode", (200.0, 400.0), (0.01, 1e-6))

        self.assertEqual(point_sentence([self.closed, cvode], seconds), "Choose the closed return throughout.")
        self.assertTrue(math.isclose(crossover([self.closed, cvode], seconds), 0))


if __name__ == "__main__":
    unittest.main()
