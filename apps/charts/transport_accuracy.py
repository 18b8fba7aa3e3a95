#!/usr/bin/python3
"""Error against cost of every transport scheme, on problems with known solutions.

Runs scree_charts, which lies beside scree, and writes transport_accuracy.csv and .md, and a picture for each problem.
"""

import argparse
import subprocess
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1] / "plot"))  # how all pictures look

from transport_chart import Finding, draw_chart  # noqa: E402
from transport_choice import choices, evaluations, seconds, sentence, unfit_integrators, warning  # noqa: E402
from transport_runs import TITLES, read_lines  # noqa: E402


def read_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--scree", type=Path, required=True, help="the program scree")
    parser.add_argument("--output", type=Path, default=Path("out/charts"), help="directory of the results")
    parser.add_argument("--quick", action="store_true", help="the two coarsest grids only, to try it")
    parser.add_argument("--table", type=Path, help="draw this table instead of running anything")
    return parser.parse_args()


def main() -> None:
    arguments = read_arguments()
    arguments.output.mkdir(parents=True, exist_ok=True)
    stem = arguments.output / "transport_accuracy"
    table = arguments.table or stem.with_suffix(".csv")
    if not arguments.table:
        command = [str(arguments.scree.with_name("scree_charts")), "--output", str(table)]
        subprocess.run([*command, "--quick"] if arguments.quick else command, check=True)
    problems = read_lines(table)
    unfit = unfit_integrators(problems)
    summary = ["# What to choose: error against cost of the transport schemes\n"]
    for problem, lines in problems.items():
        made = choices(lines, unfit, seconds)
        chosen = {choice.line.scheme for choice in made}
        finding = Finding(sentence(made), warning(made, problems, unfit), chosen)
        by_count = sentence(choices(lines, unfit, evaluations))
        words = (finding.sentence, finding.remark, f"By flux evaluations: {by_count}")
        summary.append(f"**{TITLES.get(problem, problem)}.** " + "\n".join(filter(None, words)) + "\n")
        for path in draw_chart(problem, lines, unfit, finding, stem.with_name(f"{stem.name}_{problem}")):
            print(path)
    stem.with_suffix(".md").write_text("\n".join(summary), encoding="utf-8")
    print(table, stem.with_suffix(".md"), sep="\n")


if __name__ == "__main__":
    main()
