"""The choice between ways to step material points, from runs that can be checked by hand."""

import math
import statistics
import unittest
from dataclasses import replace
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


def beside_usl(lines: list[Line]) -> list[tuple[Line, Line]]:
    """The lines of the other orders of the step, each with that of the same scheme under usl."""
    under_usl = {one.scheme: one for one in lines if one.scheme.order == "usl"}
    return [(one, under_usl[replace(one.scheme, order="usl")]) for one in lines if one.scheme.order != "usl"]


def change_of_error(pairs: list[tuple[Line, Line]], shapes: set[str], transfers: set[str]) -> tuple[float, float]:
    """The least and the largest share of the error under usl that these schemes have on the finest mesh."""
    ratios = [
        other.errors[-1] / usl.errors[-1]
        for other, usl in pairs
        if other.scheme.shape in shapes and other.scheme.transfer in transfers
    ]
    return min(ratios), max(ratios)


class WordsOfTheDocuments(unittest.TestCase):
    page = " ".join((DOCUMENTS / "mpm_choosing.md").read_text(encoding="utf-8").split())
    problems = read_lines(DOCUMENTS / "mpm_accuracy.csv")

    def test_are_those_of_their_table(self) -> None:
        self.assertEqual(self.problems.keys(), TITLES.keys())
        for problem, lines in self.problems.items():
            self.assertIn(f"**{TITLES[problem]}.** {sentence(choices(lines))}", self.page)

    def test_say_what_the_usual_scheme_costs_at_most(self) -> None:
        chosen = [choice for lines in self.problems.values() for choice in choices(lines)]

        most = max(choice.usual_seconds / choice.seconds for choice in chosen)
        self.assertIn(f"cost at most {most:.1f} times as much as the best elsewhere", self.page)
        self.assertNotIn("pic", {choice.scheme.transfer for choice in chosen})

    def test_are_of_every_order_of_the_step(self) -> None:
        for lines in self.problems.values():
            self.assertEqual({one.scheme.order for one in lines}, {"usl", "musl", "usf"})

    def test_say_what_the_other_orders_cost(self) -> None:
        swing, ring, collapse = (
            statistics.median(
                a / b for other, usl in beside_usl(self.problems[name]) for a, b in zip(other.seconds, usl.seconds) if b > 0
            )
            for name in ("swing", "turning_ring", "collapse")
        )
        self.assertIn(
            f"At the median that costs {swing:.1f} times as much on the swing, {ring:.1f} on the ring and {collapse:.1f} "
            "on the collapse",
            self.page,
        )

    def test_say_what_the_other_orders_change(self) -> None:
        pairs = {problem: beside_usl(lines) for problem, lines in self.problems.items()}
        every = [pair for some in pairs.values() for pair in some]
        least, most = change_of_error(every, {"quadratic", "cubic"}, {"apic"})
        self.assertIn(f"errors on the finest mesh are {least:.2f} to {most:.2f} of those of `usl`", self.page)
        least, most = change_of_error(pairs["turning_ring"], {"gimp"}, {"apic", "tpic", "aflip", "flip", "xpic_2"})
        self.assertIn(f"Boxes of `gimp` leave {least:.1f} to {most:.0f} times the error on the ring", self.page)
        least, most = change_of_error(pairs["collapse"], {"linear", "quadratic", "cubic", "gimp"}, {"flip"})
        self.assertIn(f"FLIP {least:.1f} to {most:.1f} times on the collapse", self.page)


if __name__ == "__main__":
    unittest.main()
