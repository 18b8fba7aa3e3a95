"""The choice between ways to step material points, from runs that can be checked by hand."""

import math
import unittest

from mpm_choice import USUAL, choices, error_levels, sentence
from mpm_runs import Line, Scheme

FLIP = Scheme("quadratic", "flip", "usl", 3)
LINEAR = Scheme("linear", "apic", "musl", 1)
NAN = math.nan


def line(scheme: Scheme, seconds: tuple[float, ...], errors: tuple[float, ...]) -> Line:
    return Line(scheme, (8, 16), seconds, errors)


class ChoiceForMaterialPoints(unittest.TestCase):
    usual = line(USUAL, (1.0, 16.0), (0.04, 0.01))

    def test_asks_for_the_best_of_the_coarsest_mesh_and_nearly_that_of_the_finest(self) -> None:
        other = line(FLIP, (1.0, 16.0), (0.032, 0.02))

        self.assertEqual(error_levels([self.usual, other]), [0.04, 0.02])

    def test_passes_over_runs_that_ended_early(self) -> None:
        self.assertEqual(error_levels([self.usual, line(LINEAR, (0.1, 0.2), (NAN, NAN))]), [0.04, 0.02])

    def test_is_the_cheapest_at_each_error(self) -> None:
        cheap = line(FLIP, (0.5, 8.0), (0.04, 0.01))

        chosen = choices([self.usual, cheap])

        self.assertEqual([choice.scheme for choice in chosen], [FLIP, FLIP])
        self.assertEqual((chosen[0].seconds, chosen[0].usual_seconds), (0.5, 1.0))

    def test_stays_with_the_usual_scheme_where_another_saves_less_than_repeats(self) -> None:
        near = line(FLIP, (0.92, 14.8), (0.04, 0.01))

        self.assertEqual([choice.scheme for choice in choices([self.usual, near])], [USUAL, USUAL])

    def test_says_what_the_usual_scheme_would_cost(self) -> None:
        cheap = line(LINEAR, (0.5, 8.0), (0.04, 0.001))

        self.assertEqual(
            sentence(choices([self.usual, cheap])),
            "For an error of 0.04 choose linear apic, 1² points, musl (quadratic apic, 2² points takes 2.0 times as "
            "long). For an error of 0.002 choose linear apic, 1² points, musl (quadratic apic, 2² points does not get "
            "there).",
        )


if __name__ == "__main__":
    unittest.main()
