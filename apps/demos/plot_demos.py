#!/usr/bin/python3
"""Draws what the demos have computed: one picture of each whose files are in the folder.

plot_demos.py FOLDER
"""

import argparse
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import NamedTuple

import matplotlib
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.image import AxesImage

PLOT = Path(__file__).resolve().parent.parent / "plot"
sys.path.append(str(PLOT))  # all pictures of scree look alike

from picture import GRAIN_COLOURS, METRES_TO_MM, TIME_COLOURS, WIDE, save  # noqa: E402

matplotlib.rcParams["figure.constrained_layout.h_pad"] = 0.12  # [inch], for titles

METRES_TO_CM = 1e2
LIMITER_COLOURS = {"minmod": "#4477aa", "van Leer": "#ee7733", "superbee": "#228833"}
SERIES_COLOURS = ("#4477aa", "#ee7733", "#228833")
FIELD_COLOURS = "magma"
OUTLIER_COLOUR = "#00d0ff"  # not in any map of colours


class Plane(NamedTuple):
    """A field on the cells of a rectangle."""

    values: np.ndarray  # [y, x]
    extent: tuple[float, float, float, float]  # low and high end of x, then of y

    @property
    def centres(self) -> tuple[np.ndarray, np.ndarray]:
        """Those of the cells, along x and along y."""
        left, right, low, high = self.extent
        num_y, num_x = self.values.shape
        return centres_between(left, right, num_x), centres_between(low, high, num_y)


def centres_between(low: float, high: float, count: int) -> np.ndarray:
    """The centres of equal cells."""
    return low + (np.arange(count) + 0.5) * (high - low) / count


def read_plane(file: Path) -> Plane:
    """Reads what write_plane wrote."""
    with file.open(encoding="utf-8") as text:
        extent = tuple(map(float, text.readline()[1:].split()))
        return Plane(np.loadtxt(text, delimiter=","), extent)


def read_table(file: Path) -> dict[str, np.ndarray]:
    """Reads what write_table wrote: columns by their names."""
    with file.open(encoding="utf-8") as text:
        names = text.readline().strip().split(",")
        return dict(zip(names, np.loadtxt(text, delimiter=",", unpack=True)))


def show(axes: Axes, plane: Plane, ticks: Sequence[Sequence[float]], **options) -> AxesImage:
    """Draws a field, each cell in its colour."""
    image = axes.imshow(plane.values, origin="lower", extent=plane.extent, interpolation="nearest", **options)
    axes.spines[:].set_visible(False)
    axes.set(xticks=ticks[0], yticks=ticks[1])
    return image


def draw_contours(axes: Axes, plane: Plane, levels: Sequence[float], **options) -> None:
    """Draws lines of equal value, thin enough to see what is below."""
    axes.contour(*plane.centres, plane.values, levels=levels, **{"colors": "white", "linewidths": 0.6} | options)


def draw_burgers(folder: Path) -> list[Path]:
    """The wave as it steepens, and the three limiters at the shock."""
    waves = read_table(folder / "burgers_waves.csv")
    exact = read_table(folder / "burgers_exact.csv")
    limiters = read_table(folder / "burgers_limiters.csv")
    last = list(waves)[-1]
    x, fine_x = (centres_between(0, 2 * np.pi, len(u)) for u in (waves[last], exact[last]))
    figure, (left, right) = plt.subplots(1, 2, figsize=WIDE, layout="constrained", width_ratios=(3, 2))
    for (time, wave), colour in zip(waves.items(), plt.get_cmap(TIME_COLOURS)(np.linspace(0.8, 0, len(waves)))):
        left.plot(fine_x, exact[time], color=colour, linewidth=1.8)
        left.plot(x, wave, "o", color=colour, markersize=6)
        crest = np.argmax(exact[time])
        label = f"{float(time):g}" if float(time) > 0 else "t = 0"
        left.text(fine_x[crest], 1.54, label, color=colour, ha="center", fontweight="bold")
    left.set(title="A sine becomes a shock", xlabel="x", ylabel="u", xlim=(0, 2 * np.pi), ylim=(-0.6, 1.7))
    right.plot(fine_x, exact[last], color="black", linewidth=1.8, label="exact")
    for name, marker in zip(limiters, "so^"):
        colour = LIMITER_COLOURS[name]
        right.plot(x, limiters[name], marker, color=colour, label=name, ms=11, mfc="none", mew=2.5)
    right.set(title="Limiters behind the shock, t = 2", xlabel="x", xlim=(3.1, 4.25), ylim=(1.08, 1.5))
    right.legend(frameon=False, loc="upper left", borderaxespad=0)
    return save(figure, folder / "burgers")


def draw_euler_riemann(folder: Path) -> list[Path]:
    """The density of the whole square, and of its middle with contours."""
    density = read_plane(folder / "euler_riemann.csv")
    figure, (left, right) = plt.subplots(1, 2, figsize=(15, 7), layout="constrained")
    show(left, density, [(0, 0.5, 1)] * 2, cmap=FIELD_COLOURS)
    image = show(right, density, [(0.2, 0.3, 0.4, 0.5)] * 2, cmap=FIELD_COLOURS)
    draw_contours(right, density, np.linspace(0.16, 1.71, 32))
    left.set(title="Four shocks meet in the corner of a dense gas", xlabel="x [m]", ylabel="y [m]")
    right.set(title="The jet that they drive along the diagonal", xlabel="x [m]")
    right.set(xlim=(0.2, 0.55), ylim=(0.2, 0.55))
    figure.colorbar(image, ax=right, label="density [kg/m³]", shrink=0.9)
    return save(figure, folder / "euler_riemann")


def draw_slotted_disk(folder: Path) -> list[Path]:
    """What each limiter leaves after one turn."""
    start = read_plane(folder / "slotted_disk_start.csv")
    figure, grid = plt.subplots(2, 2, figsize=(10, 10.6), layout="constrained", sharex=True, sharey=True)
    figure.suptitle("A slotted disk after one turn, 100 x 100 cells\n(line: its outline, that is u = 1/2, before)")
    names = {"minmod": "minmod", "van_leer": "van Leer", "mc": "monotonised central", "superbee": "superbee"}
    for (name, title), axes in zip(names.items(), grid.flat):
        disk = read_plane(folder / f"slotted_disk_{name}.csv")
        error = np.abs(disk.values - start.values).sum() / start.values.sum()
        show(axes, disk, [(0.4, 0.5, 0.6), (0.6, 0.75, 0.9)], cmap=GRAIN_COLOURS, vmin=0, vmax=1)
        draw_contours(axes, start, [0.5], linewidths=2)
        axes.set(title=f"{title}: error {error:.2f}", xlim=(0.3, 0.7), ylim=(0.55, 0.95))
    return save(figure, folder / "slotted_disk")


def draw_kpp(folder: Path) -> list[Path]:
    """The composite wave, right and wrong; what left the bounds stands out."""
    low, high = np.pi / 4, 14 * np.pi / 4
    colours = plt.get_cmap(FIELD_COLOURS).with_extremes(under=OUTLIER_COLOUR, over=OUTLIER_COLOUR)
    figure, both = plt.subplots(1, 2, figsize=(15, 7), layout="constrained", sharey=True)
    titles = {"right": "Speed bounded between two states", "wrong": "Speed at two states alone (blue: out of bounds)"}
    for axes, (name, title) in zip(both, titles.items()):
        wave = read_plane(folder / f"kpp_{name}.csv")
        image = show(axes, wave, [(-1, 0, 1), (-2, -1, 0, 1)], cmap=colours, vmin=0.999 * low, vmax=1.001 * high)
        draw_contours(axes, wave, np.linspace(low, high, 22)[1:-1])
        axes.set(title=title, xlabel="x")
    both[0].set_ylabel("y")
    figure.colorbar(image, ax=both, label="u", shrink=0.9)
    return save(figure, folder / "kpp")


def draw_loading_path(folder: Path) -> list[Path]:
    """Shear stress and change of volume over axial compression, a curve for each pressure round the soil."""
    path = read_table(folder / "loading_path.csv")
    pressures = [name.removeprefix("q_") for name in path if name.startswith("q_")]
    compression = 1e2 * path["axial"]
    figure, (left, right) = plt.subplots(1, 2, figsize=WIDE, layout="constrained")
    for pressure, colour in zip(pressures, SERIES_COLOURS):
        stress, volume = 1e-3 * path[f"q_{pressure}"], 1e2 * path[f"volume_{pressure}"]
        for axes, curve in (left, stress), (right, volume):
            axes.plot(compression, curve, color=colour)
        left.text(3, stress[-1] + 0.15, f"{float(pressure) / 1e3:g} kPa", color=colour, ha="right", fontweight="bold")
    left.set(title="Strength grows with the pressure round it", ylabel="q [kPa]", ylim=(0, 13))
    right.set(title="Squeezed first, then dilating alike", ylabel="volume [%]")
    for axes in (left, right):
        axes.set(xlabel="axial compression [%]", xlim=(0, 3))
    return save(figure, folder / "loading_path")


def draw_creeping_layer(folder: Path) -> list[Path]:
    """The fluidity over the height, as computed and exact, for three distances to yield."""
    layer = read_table(folder / "creeping_layer.csv")
    grains = METRES_TO_MM * layer["y"]  # of 1 mm
    figure, axes = plt.subplots(figsize=WIDE, layout="constrained")
    distances = [name.removeprefix("g_") for name in layer if name.startswith("g_")]
    for distance, colour in zip(distances, SERIES_COLOURS):
        axes.plot(layer[f"exact_{distance}"], grains, color=colour, linewidth=1.8)
        axes.plot(layer[f"g_{distance}"][::4], grains[::4], "o", color=colour, markersize=7)
        label = f"µ = µs - {float(distance):g}"
        axes.text(layer[f"g_{distance}"][-1], grains[-1] + 0.4, label, color=colour, fontweight="bold")
    axes.set(title="Creep below yield: nonlocal fluidity (dots) and exact (lines)", xscale="log", xlim=(1e-5, 1.5))
    axes.set(xlabel="fluidity / fluidity of the base", ylabel="height [grains]", ylim=(0, 21.5))
    return save(figure, folder / "creeping_layer")


def draw_segregation_column(folder: Path) -> list[Path]:
    """The mean size over height and time, and the exact fronts."""
    sizes = read_plane(folder / "segregation_column.csv")
    fronts = read_table(folder / "segregation_fronts.csv")
    figure, axes = plt.subplots(figsize=WIDE, layout="constrained")
    low, high, start, end = sizes.extent
    extent = (start, end, METRES_TO_CM * low, METRES_TO_CM * high)
    values = METRES_TO_MM * sizes.values.T
    image = axes.imshow(values, origin="lower", aspect="auto", cmap=GRAIN_COLOURS, extent=extent)
    axes.plot(fronts["time"], METRES_TO_CM * fronts["front"], ".", color="white", markersize=2.5)
    heights = METRES_TO_CM * sizes.centres[0]
    for size in (0.25, 0.5, 0.75, 1):
        layer = heights[np.isclose(values[:, -1], size, atol=0.02)]
        colour = "white" if size < 0.6 else "black"
        axes.text(0.97 * end, layer.mean(), f"{size:g} mm", ha="right", va="center", color=colour, fontweight="bold")
    axes.set(title="Four sizes sort themselves: scheme (colour) and exact fronts (dots)")
    axes.set(xlabel="time [s]", ylabel="height [cm]")
    figure.colorbar(image, label="mean grain size [mm]")
    return save(figure, folder / "segregation_column")


def draw_free_fall(folder: Path) -> list[Path]:
    """How far a block has fallen, and how much of that is the step's."""
    fall = read_table(folder / "free_fall.csv")
    figure, (left, right) = plt.subplots(1, 2, figsize=WIDE, layout="constrained")
    left.plot(fall["time"], fall["theory"], color=SERIES_COLOURS[0])
    left.plot(fall["time"][::50], fall["way"][::50], "o", color="black", markersize=7)
    left.set(title="A block (dots) falls by g t²/2 (line)", xlabel="time [s]", ylabel="way [m]")
    right.plot(fall["time"], METRES_TO_MM * (fall["way_of_the_step"] - fall["theory"]), color=SERIES_COLOURS[0])
    right.plot(
        fall["time"][::50], METRES_TO_MM * (fall["way"] - fall["theory"])[::50], "o", color="black", markersize=7
    )
    right.set(title="ahead by g t dt/2, as its steps are", xlabel="time [s]", ylabel="ahead of theory [mm]")
    return save(figure, folder / "free_fall")


def draw_elastic_bar(folder: Path) -> list[Path]:
    """The last period of a ringing bar, on three meshes."""
    bar = read_table(folder / "elastic_bar.csv")
    last = bar["period"] >= 4
    figure, axes = plt.subplots(figsize=WIDE, layout="constrained")
    axes.plot(bar["period"][last], bar["theory"][last], color="black", linewidth=1.8)
    for cells, colour in zip((10, 20, 40), SERIES_COLOURS):
        axes.plot(bar["period"][last], bar[f"cells_{cells}"][last], color=colour, linestyle="--")
        at = 4.6 + 0.08 * (cells // 20)
        axes.text(at, 0.95 - 0.12 * (cells // 20), f"{cells} cells", color=colour, fontweight="bold", ha="right")
    axes.set(title="A bar rings, a little too slowly: theory (line) and scheme (dashed)")
    axes.set(xlabel="time [periods]", ylabel="velocity / velocity at the start", xlim=(4, 5))
    return save(figure, folder / "elastic_bar")


def draw_shallow_dam_break(folder: Path) -> list[Path]:
    """The depth at three times; cells without water are walls."""
    colours = plt.get_cmap("GnBu").with_extremes(bad="#4d4237")
    figure, panels = plt.subplots(3, 1, figsize=(11, 13.4), layout="constrained", sharex=True)
    for time, axes in enumerate(panels, 1):
        depth = read_plane(folder / f"shallow_dam_break_{time}.csv")
        water = depth._replace(values=np.ma.masked_equal(depth.values, 0))
        image = show(axes, water, [(0, 5, 10, 15, 20), (0, 5, 10)], cmap=colours, vmin=0, vmax=2)
        draw_contours(axes, water, np.arange(0.15, 2, 0.1), colors="black", alpha=0.5)
        axes.set(ylabel="y [m]")
        axes.text(19.6, 9.6, f"{time} s", ha="right", va="top", fontweight="bold", color="black")
    panels[0].set_title("A dam breaks: water, walls and three islands")
    panels[-1].set_xlabel("x [m]")
    figure.colorbar(image, ax=panels, label="depth [m]", shrink=0.5)
    return save(figure, folder / "shallow_dam_break")


def draw_sliding_block(folder: Path) -> list[Path]:
    """How far a block has slid, and theory."""
    slide = read_table(folder / "sliding_block.csv")
    figure, axes = plt.subplots(figsize=WIDE, layout="constrained")
    axes.plot(slide["time"], slide["theory"], color=SERIES_COLOURS[0])
    axes.plot(slide["time"][::2], slide["way"][::2], "o", color="black", markersize=7)
    axes.set(title="A block (dots) slides 19.86 m in 5 s (line), at 24° with µ = tan 15°")
    axes.set(xlabel="time [s]", ylabel="way down the bed [m]", xlim=(0, 5.1), ylim=(0, None))
    return save(figure, folder / "sliding_block")


def draw_water_column(folder: Path) -> list[Path]:
    """The front of a column of water that collapses, and where it was seen."""
    seen = read_table(folder / "water_column.csv")
    figure, axes = plt.subplots(figsize=WIDE, layout="constrained")
    axes.plot(seen["time"], seen["front"], color=SERIES_COLOURS[0])
    axes.plot(seen["time"], seen["experiment"], "o", color="black", markersize=7)
    axes.set(title="A column of water collapses: its front (line) and an experiment (dots)")
    axes.set(xlabel="time [√(width/2g)]", ylabel="front [widths]", xlim=(0, 3.5), ylim=(1, None))
    return save(figure, folder / "water_column")


def draw_own_law(folder: Path) -> list[Path]:
    """The speed of a layer over its height, and theory."""
    layer = read_table(folder / "own_law.csv")
    order = np.argsort(layer["y"])
    y = METRES_TO_CM * layer["y"][order]
    figure, axes = plt.subplots(figsize=WIDE, layout="constrained")
    axes.plot(layer["theory"][order], y, color=SERIES_COLOURS[0])
    axes.plot(layer["velocity"][order][::4], y[::4], "o", color="black", markersize=7)
    axes.set(title="Your own law: Bagnold's grains (dots) and theory (line)")
    axes.set(xlabel="speed [m/s]", ylabel="height [cm]", xlim=(0, None), ylim=(0, None))
    return save(figure, folder / "own_law")


def draw_own_wall(folder: Path) -> list[Path]:
    """The speed of a block on a film of oil over time, and theory."""
    slide = read_table(folder / "own_wall.csv")
    every = max(1, len(slide["time"]) // 30)
    figure, axes = plt.subplots(figsize=WIDE, layout="constrained")
    axes.plot(slide["time"], slide["theory"], color=SERIES_COLOURS[0])
    axes.plot(slide["time"][::every], slide["velocity"][::every], "o", color="black", markersize=7)
    axes.set(title="Your own wall: a block on a film of oil (dots) and theory (line)")
    axes.set(xlabel="time [s]", ylabel="speed [m/s]", xlim=(0, None), ylim=(0, None))
    return save(figure, folder / "own_wall")


PICTURES: dict[str, Callable[[Path], list[Path]]] = {
    "burgers_waves.csv": draw_burgers,
    "creeping_layer.csv": draw_creeping_layer,
    "elastic_bar.csv": draw_elastic_bar,
    "euler_riemann.csv": draw_euler_riemann,
    "free_fall.csv": draw_free_fall,
    "kpp_right.csv": draw_kpp,
    "loading_path.csv": draw_loading_path,
    "own_law.csv": draw_own_law,
    "own_wall.csv": draw_own_wall,
    "segregation_column.csv": draw_segregation_column,
    "shallow_dam_break_1.csv": draw_shallow_dam_break,
    "sliding_block.csv": draw_sliding_block,
    "slotted_disk_minmod.csv": draw_slotted_disk,
    "water_column.csv": draw_water_column,
}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path, help="where the demos have written")
    folder = parser.parse_args().folder
    for file, draw in PICTURES.items():
        if (folder / file).exists():
            for picture in draw(folder):
                print(picture)


if __name__ == "__main__":
    main()
