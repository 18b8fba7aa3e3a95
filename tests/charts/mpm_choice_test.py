"""The choice between ways to step material points, from runs that can be checked by hand."""

import math
import unittest
from pathlib import Path

from mpm_choice import USUAL, choices, error_levels, sentence
from mpm_runs import TITLES, Line, Scheme, read_lines

FLIP = Scheme("quadratic", "flip", "usl", 3)
LINEAR = Scheme("linear", "apic", "musl", 1)
NAN = math.nan
DOCUMENTS = Path(__file__).resolve().parents[2] / "docs" / "schemes"


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
        near = line(FLIP, (0.81, 12.9), (0.04, 0.01))

        self.assertEqual([choice.scheme for choice in choices([self.usual, near])], [USUAL, USUAL])

    def test_says_what_the_usual_scheme_would_cost(self) -> None:
        cheap = line(LINEAR, (0.5, 8.0), (0.04, 0.001))

        self.assertEqual(
            sentence(choices([self.usual, cheap])),
            "For an error of 0.04 choose linear apic, 1² points, musl (quadratic apic, 2² points takes 2.0 times as "
            "long). For an error of 0.002 choose linear apic, 1² points, musl (quadratic apic, 2² points does not get "
            "there).",
        )

    def test_says_how_much_longer_the_other_orders_take(self) -> None:
        musl = line(Scheme("quadratic", "apic", "musl", 2), (1.5, 32.0), (0.04, 0.01))
        usf = line(Scheme("linear", "flip", "usf", 2), (2.0, 32.0), (0.04, 0.01))

        self.assertEqual(
            sentence(choices([self.usual, musl, usf])),
            "For an error of 0.04 choose quadratic apic, 2² points. For an error of 0.02 choose quadratic apic, 2² "
            "points. On 2² points, beside the best of usl, that of musl takes 1.5 to 1.7 times as long, of usf takes 2.0 "
            "times as long.",
        )

    def test_says_where_an_order_does_not_get(self) -> None:
        musl = line(Scheme("quadratic", "apic", "musl", 2), (1.0, 16.0), (0.04, 0.03))
        usf = line(Scheme("quadratic", "apic", "usf", 2), (1.0, 16.0), (0.04, 0.01))

        self.assertIn(
            "that of musl does not get to every error, of usf takes 1.0 times as long.",
            sentence(choices([self.usual, musl, usf])),
        )


class WordsOfTheDocuments(unittest.TestCase):
    def test_are_those_of_their_table(self) -> None:
        page = " ".join((DOCUMENTS / "mpm_choosing.md").read_text(encoding="utf-8").split())

        problems = read_lines(DOCUMENTS / "mpm_accuracy.csv")

        self.assertEqual(problems.keys(), TITLES.keys())
        for problem, lines in problems.items():
            self.assertIn(f"**{TITLES[problem]}.** {sentence(choices(lines))}", page)

    def test_say_what_the_usual_scheme_costs_at_most(self) -> None:
        page = " ".join((DOCUMENTS / "mpm_choosing.md").read_text(encoding="utf-8").split())

        chosen = [choice for lines in read_lines(DOCUMENTS / "mpm_accuracy.csv").values() for choice in choices(lines)]

        most = max(choice.usual_seconds / choice.seconds for choice in chosen)
        self.assertIn(f"cost at most {most:.1f} times as much as the best elsewhere", page)
        self.assertNotIn("pic", {choice.scheme.transfer for choice in chosen})

    def test_are_of_every_order_of_the_step(self) -> None:
        for lines in read_lines(DOCUMENTS / "mpm_accuracy.csv").values():
            self.assertEqual({one.scheme.order for one in lines}, {"usl", "musl", "usf"})


if __name__ == "__main__":
    unittest.main()
