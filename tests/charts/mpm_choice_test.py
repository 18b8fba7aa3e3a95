"""The choice between ways to step material points, from runs that can be checked by hand."""

import math
import statistics
import unittest
from collections.abc import Iterable
from dataclasses import replace
from itertools import product
from pathlib import Path

from mpm_choice import EQUAL_COSTS, USUAL, choices, error_levels, sentence
from mpm_runs import TITLES, Line, Scheme, read_lines

FLIP = Scheme("quadratic", "flip", "usl", 3)
DEFAULT_OF_SCENES = Scheme("linear", "apic", "usl", 3)
LINEAR = Scheme("linear", "apic", "musl", 1)
NAN = math.nan
SHAPES = ("linear", "quadratic", "cubic", "gimp")
TRANSFERS = ("pic", "flip", "xpic_2", "apic", "tpic", "aflip")
ORDERS = ("usl", "musl", "usf")
SPLINES = {"quadratic", "cubic"}
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

    def test_lies_on_the_line_of_its_scheme(self) -> None:
        better = line(FLIP, (0.5, 8.0), (0.032, 0.005))

        chosen = choices([line(USUAL, (1.0, 16.0), (0.04, 0.02)), better])

        self.assertEqual([choice.error for choice in chosen], [0.04, 0.008])
        self.assertEqual([choice.reached for choice in chosen], [0.032, 0.008])

    def test_stays_with_the_usual_scheme_where_another_saves_less_than_repeats(self) -> None:
        near = line(FLIP, (0.81, 12.9), (0.04, 0.01))

        self.assertEqual([choice.scheme for choice in choices([self.usual, near])], [USUAL, USUAL])

    def test_is_the_one_most_like_the_usual_where_costs_are_equal(self) -> None:
        cheap = line(replace(USUAL, order="musl", points_per_axis=1), (0.5, 8.0), (0.04, 0.01))
        alike = line(replace(USUAL, points_per_axis=1), (0.6, 9.6), (0.04, 0.01))

        self.assertEqual([choice.scheme for choice in choices([self.usual, cheap, alike])], [alike.scheme] * 2)

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
            "points. Beside the best of usl, that of musl takes 1.5 to 1.7 times as long, of usf takes 2.0 times as long.",
        )

    def test_takes_the_best_of_an_order_from_any_number_of_points(self) -> None:
        order = [line(Scheme("cubic", "tpic", "musl", n), (n, 16.0 * n), (0.04, 0.01)) for n in (3, 2)]

        self.assertEqual([c.order_seconds["musl"] / c.seconds for c in choices([self.usual, *order])], [2.0, 2.0])

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


def is_on_one_point_or_hats(scheme: Scheme) -> bool:
    return scheme.points_per_axis == 1 or scheme.shape == "linear"


def extremes(ratios: Iterable[float]) -> tuple[float, float]:
    """The least and the largest; NaN, a run that ended early, is passed over."""
    finite = [ratio for ratio in ratios if math.isfinite(ratio)]
    return min(finite), max(finite)


def change_of_error(pairs: list[tuple[Line, Line]], shapes: set[str], transfers: set[str]) -> tuple[float, float]:
    """The least and the largest share of the error under usl that these schemes have on the finest mesh."""
    return extremes(
        other.errors[-1] / usl.errors[-1]
        for other, usl in pairs
        if other.scheme.shape in shapes and other.scheme.transfer in transfers
    )


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
        usual = [choice.scheme == USUAL for choice in chosen]  # two errors of each problem, as in the table
        self.assertEqual(usual, [False, False, False, True, True, True], "the collapse, a small error of the ring")
        self.assertNotIn("pic", {choice.scheme.transfer for choice in chosen})
        self.assertEqual({choice.scheme.order for choice in chosen}, {"usl"})

    def test_are_of_every_scheme_on_three_meshes(self) -> None:
        schemes = {Scheme(*parts) for parts in product(SHAPES, TRANSFERS, ORDERS, (1, 2, 3))}
        for lines in self.problems.values():
            self.assertEqual({one.scheme for one in lines}, schemes)
            self.assertEqual({len(one.cells) for one in lines}, {3})

    def test_say_what_the_other_orders_cost(self) -> None:
        swing, ring, collapse = (
            statistics.median(
                other.seconds[i] / usl.seconds[i]
                for other, usl in beside_usl(self.problems[name])
                for i in range(3)
                if math.isfinite(other.errors[i]) and math.isfinite(usl.errors[i])
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
        least, most = change_of_error(every, SPLINES, {"apic"})
        self.assertIn(f"errors on the finest mesh are {least:.2f} to {most:.2f} of those of `usl`", self.page)
        least, most = change_of_error(pairs["collapse"], {*SHAPES}, {"flip"})
        self.assertIn(f"FLIP has {least:.1f} to {most:.1f} times the error on the collapse", self.page)
        (least, most), (least_on_nine, most_on_nine) = (
            change_of_error(
                [pair for pair in pairs["turning_ring"] if pair[0].scheme.points_per_axis == number],
                {"gimp"},
                {*TRANSFERS} - {"pic"},
            )
            for number in (2, 3)
        )
        self.assertIn(
            f"`gimp` on \\f$2^2\\f$ points leave {least:.1f} to {most:.0f} times the error on the ring, on \\f$3^2\\f$ points "
            f"{least_on_nine:.1f} to {most_on_nine:.1f} times (all but `pic`).",
            self.page,
        )

    def test_say_where_the_other_orders_cost_the_same(self) -> None:
        self.assertIn("not the choice anywhere, nor cheaper anywhere, and on the swing equal.", self.page)
        for problem, lines in self.problems.items():
            for choice in choices(lines):
                for order in ("musl", "usf"):
                    factor = choice.order_seconds[order] / choice.order_seconds["usl"]
                    self.assertGreater(factor, 1)
                    self.assertEqual(factor <= 1 + EQUAL_COSTS, problem == "swing", (problem, order))

    def test_say_where_refining_does_not_help(self) -> None:
        ring = [one for one in self.problems["turning_ring"] if one.scheme.transfer != "pic"]
        coarse, fine = ring[0].cells[1:]
        least, most = extremes(one.errors[2] / one.errors[1] for one in ring if is_on_one_point_or_hats(one.scheme))
        self.assertIn(
            f"from {coarse} to {fine} cells the ring has {least:.1f} to {most:.0f} times the error, or its runs end early, in "
            "every order",
            self.page,
        )
        boxes = {
            one.scheme: one.errors[2] / one.errors[1]
            for one in ring
            if one.scheme.shape == "gimp" and one.scheme.points_per_axis == 2
        }
        least, most = extremes(ratio for scheme, ratio in boxes.items() if scheme.order != "usl")
        under_usl = {scheme.transfer: ratio for scheme, ratio in boxes.items() if scheme.order == "usl"}
        self.assertGreater(least, 1)
        self.assertEqual([transfer for transfer, ratio in under_usl.items() if ratio > 1], ["aflip"])
        self.assertEqual(str(choices(self.problems["turning_ring"])[0].scheme), "gimp apic, 2² points")
        self.assertIn(
            f"`gimp` on \\f$2^2\\f$ points then have {least:.1f} to {most:.1f} times the error under `musl` and `usf` (all but "
            f"`pic`), and with `aflip` {under_usl['aflip']:.1f} times under `usl`; with `apic` under `usl`, the choice for "
            f"{choices(self.problems['turning_ring'])[0].error:g}, {under_usl['apic']:.2f} times.",
            self.page,
        )
        remedy = [one for one in ring if one.scheme.shape in SPLINES and not is_on_one_point_or_hats(one.scheme)]
        least, most = extremes(one.errors[2] / one.errors[1] for one in remedy)
        self.assertIn(f"splines on \\f$2^2\\f$ or \\f$3^2\\f$ points, {least:.2f} to {most:.2f} times", self.page)
        self.assertTrue(all(math.isfinite(error) for one in remedy for error in one.errors))

    def test_say_where_runs_end_early(self) -> None:
        ended = {
            problem: [(one.scheme, n) for one in lines for n, error in zip(one.cells, one.errors) if math.isnan(error)]
            for problem, lines in self.problems.items()
        }
        runs = sum(len(one.cells) for one in self.problems["collapse"] if one.scheme.shape == "linear")
        self.assertIn(
            f"{len(ended['collapse'])} of their {runs} runs of the collapse, {len(ended['turning_ring'])} of the ring and "
            f"{len(ended['swing'])} of the swing, among them the default of scenes (`apic`, `usl`, \\f$3^2\\f$ points) in the "
            "collapse on 12 cells. No run on other shapes did. *Remedy*: `quadratic`.",
            self.page,
        )
        self.assertIn((DEFAULT_OF_SCENES, 12), ended["collapse"])
        self.assertEqual({scheme.shape for some in ended.values() for scheme, _ in some}, {"linear"})


if __name__ == "__main__":
    unittest.main()
