#!/usr/bin/python3
"""Error against cost of material points: shape x transfer x order x points per cell.

Runs scree_mpm_charts, which lies beside scree, and writes mpm_accuracy.csv and .md, and a picture.
"""

import argparse
import subprocess
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1] / "plot"))  # how all pictures look

from mpm_chart import draw  # noqa: E402
from mpm_choice import choices, sentence  # noqa: E402
from mpm_runs import TITLES, read_lines  # noqa: E402


def read_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--scree", type=Path, required=True, help="the program scree")
    parser.add_argument("--output", type=Path, default=Path("out/charts"), help="directory of the results")
    parser.add_argument("--quick", action="store_true", help="one shape and one mesh, to try it")
    parser.add_argument("--table", type=Path, help="draw this table instead of running anything")
    return parser.parse_args()


def main() -> None:
    arguments = read_arguments()
    arguments.output.mkdir(parents=True, exist_ok=True)
    stem = arguments.output / "mpm_accuracy"
    table = arguments.table or stem.with_suffix(".csv")
    if not arguments.table:
        command = [str(arguments.scree.with_name("scree_mpm_charts")), "--output", str(table)]
        subprocess.run([*command, "--quick"] if arguments.quick else command, check=True)
    problems = read_lines(table)
    chosen = {problem: choices(lines) for problem, lines in problems.items()}
    sentences = {problem: sentence(choice) for problem, choice in chosen.items()}
    pictures = draw(problems, chosen, sentences, stem)
    summary = ["# What to choose: error against cost of material points\n"]
    summary += [f"**{TITLES[problem]}.** {words}\n" for problem, words in sentences.items()]
    stem.with_suffix(".md").write_text("\n".join(summary), encoding="utf-8")
    print(*pictures, table, stem.with_suffix(".md"), sep="\n")


if __name__ == "__main__":
    main()
