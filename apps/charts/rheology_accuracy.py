#!/usr/bin/python3
"""Error against cost of what advances stiff rheology: viscosity of a layer, laws at a point.

Runs scree_rheology_charts, which lies beside scree, and writes rheology_accuracy.csv and .md, and pictures.
"""

import argparse
import subprocess
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1] / "plot"))  # how all pictures look

from rheology_chart import draw_layer, draw_points  # noqa: E402
from rheology_choice import comparisons, layer_sentence, point_sentence, ranges, saving  # noqa: E402
from rheology_runs import LAYERS, POINTS, TITLES, applications, read_lines, seconds  # noqa: E402


def read_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--scree", type=Path, required=True, help="the program scree")
    parser.add_argument("--output", type=Path, default=Path("out/charts"), help="directory of the results")
    parser.add_argument("--quick", action="store_true", help="one parameter and few steps, to try it")
    parser.add_argument("--table", type=Path, help="draw this table instead of running anything")
    return parser.parse_args()


def main() -> None:
    arguments = read_arguments()
    arguments.output.mkdir(parents=True, exist_ok=True)
    stem = arguments.output / "rheology_accuracy"
    table = arguments.table or stem.with_suffix(".csv")
    if not arguments.table:
        command = [str(arguments.scree.with_name("scree_rheology_charts")), "--output", str(table)]
        subprocess.run([*command, "--quick"] if arguments.quick else command, check=True)
    problems = read_lines(table)
    summary = ["# What to choose: error against cost of stiff rheology\n"]
    pictures = []
    for problem in LAYERS:
        by_cost = {}
        for name, cost in {"CPU time": seconds, "applications of the operator": applications}.items():
            compared = comparisons(problems[problem], cost)
            by_cost[name] = compared, ranges(compared)
        by_time, by_count = (layer_sentence(chosen) for _, chosen in by_cost.values())
        sentence = f"{by_time} {saving(*by_cost['CPU time'])}"
        summary.append(f"**{TITLES[problem]}.** {sentence}\nBy applications: {by_count}\n")
        path = stem.with_name(f"{stem.name}_{problem}")
        pictures += draw_layer(problem, problems[problem], by_cost, sentence, path)
    points = {problem: problems[problem][0.0] for problem in POINTS}
    sentences = {problem: point_sentence(lines, seconds) for problem, lines in points.items()}
    for problem, lines in points.items():
        by_count = point_sentence(lines, applications)
        summary.append(f"**{TITLES[problem]}.** {sentences[problem]}\nBy evaluations of the law: {by_count}\n")
    pictures += draw_points(points, sentences, seconds, stem.with_name(f"{stem.name}_points"))
    stem.with_suffix(".md").write_text("\n".join(summary), encoding="utf-8")
    print(*pictures, table, stem.with_suffix(".md"), sep="\n")


if __name__ == "__main__":
    main()
