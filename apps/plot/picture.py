"""How all pictures look, and how they are saved: one size, for a projector, and colours that survive grey print."""

from collections.abc import Sequence
from pathlib import Path

import matplotlib
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

GRAIN_COLOURS = "viridis"  # small grains dark, large grains light; lightness is monotone and even
TIME_COLOURS = "plasma"
METRES_TO_MM = 1e3
WIDE = (12, 6.75)  # [inch]
CHARACTER_WIDTH = 0.029  # [-], of one of two panels

matplotlib.use("Agg")
matplotlib.rcParams.update(
    {
        "font.size": 18,
        "axes.titlesize": 18,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "axes.linewidth": 1.2,
        "lines.linewidth": 3.5,
        "savefig.dpi": 130,
        "svg.hashsalt": "scree",  # the same picture is the same file
    }
)


def save(figure: Figure, stem: Path) -> list[Path]:
    """Writes a picture as PNG and SVG and closes it; returns their paths."""
    paths = [stem.with_suffix(".png"), stem.with_suffix(".svg")]
    figure.savefig(paths[0])
    figure.savefig(paths[1], metadata={"Date": None})
    plt.close(figure)
    return paths


def spread(places: Sequence[float], distance: float, low: float, high: float) -> np.ndarray:
    """Moves places apart until neighbours are `distance` apart within [low, high], keeping their order."""
    order = np.argsort(places, kind="stable")
    moved = np.asarray(places, dtype=float)[order]
    distance = min(distance, (high - low) / max(1, len(moved) - 1))
    for i in range(1, len(moved)):
        moved[i] = max(moved[i], moved[i - 1] + distance)
    moved[-1] = min(moved[-1], high)
    for i in reversed(range(len(moved) - 1)):
        moved[i] = min(moved[i], moved[i + 1] - distance)
    result = np.empty_like(moved)
    result[order] = moved
    return result


def label_above(
    axes: Axes, places: Sequence[float], tops: Sequence[float], labels: Sequence[str], colours: np.ndarray
) -> None:
    """Names curves above the axes, where each one ends at (place, top), with a thin line from the label down."""
    low, high = axes.get_xlim()
    distance = CHARACTER_WIDTH * max(map(len, labels)) * (high - low)
    label_places = spread(places, distance, low, high)
    for place, top, label_place, label, colour in zip(places, tops, label_places, labels, colours):
        axes.annotate(
            label,
            xy=(place, top),
            xytext=(label_place, 1.06),
            textcoords=axes.get_xaxis_transform(),
            ha="center",
            va="bottom",
            color=colour,
            fontweight="bold",
            arrowprops={"arrowstyle": "-", "color": colour, "linewidth": 1, "shrinkA": 0, "shrinkB": 2},
            annotation_clip=False,
        )
