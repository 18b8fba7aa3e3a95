#!/usr/bin/python3
"""Draws the pictures of a run into its directory and prints their paths.

Exits with 2 if the directory holds no run.
"""

import argparse
import sys
from pathlib import Path

import scene as scenes
from flow import draw_flow
from grain_size import draw_grain_size
from points import draw_points
from profiles import draw_profiles
from read_run import Run, RunError


def draw(run: Run) -> list[Path]:
    """Draws all pictures that the run has the columns and dimensions for; returns their paths."""
    paths = draw_profiles(run)
    if run.has("grain_size"):
        paths += draw_grain_size(run)
        if scenes.dimensions(run.scene) > 1:
            paths += draw_points(run)
    if scenes.dimensions(run.scene) > 1 and run.scene["boundaries"].get("x") != "periodic" and run.has("velocity"):
        paths += draw_flow(run)
    return sorted(paths)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("directory", type=Path, help="the directory that a run wrote")
    try:
        paths = draw(Run(parser.parse_args().directory))
    except (RunError, OSError) as error:
        print(f"scree plot: {error}", file=sys.stderr)
        return 2
    print("\n".join(map(str, paths)))
    return 0


if __name__ == "__main__":
    sys.exit(main())
