"""Diagrams as data URLs of SVG pictures, whose text stays text."""

import base64
import io

import matplotlib
import numpy

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402  (after the choice of backend)

matplotlib.rcParams.update({
    "svg.fonttype": "none",
    "font.family": "sans-serif",
    "font.size": 9,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.edgecolor": "#888",
    "axes.grid": True,
    "grid.color": "#e8e8e8",
    "axes.axisbelow": True,
    "legend.frameon": False,
    "lines.linewidth": 1.4,
})

RUN_COLOURS = ("#1f5f99", "#c44e2b", "#3b8f5a", "#7d5ba6", "#b58a1b",
               "#4aa3b5", "#a8476f", "#6b6b6b")
CLASSES = (("anterior_primary", "Anterior primary"),
           ("posterior_primary", "Posterior primary"),
           ("anterior_secondary", "Anterior secondary"),
           ("posterior_secondary", "Posterior secondary"))


def encoded(figure, dpi=100):
    """A figure as a data URL; parts that are rasterised have this many dots
    per inch."""
    stream = io.BytesIO()
    figure.savefig(stream, format="svg", dpi=dpi, metadata={"Date": None})
    pyplot.close(figure)
    return ("data:image/svg+xml;base64," +
            base64.b64encode(stream.getvalue()).decode())


def colour_of(i):
    """Colour of the run number i."""
    return RUN_COLOURS[i % len(RUN_COLOURS)]


def figure_of(n_rows=1, n_columns=1, height=2.9, **options):
    """A figure that fits a narrow column."""
    return pyplot.subplots(n_rows, n_columns, figsize=(4.6, height),
                           layout="constrained", squeeze=False, **options)


def flow_figure(runs):
    """Flow into the atrium, and what drives it."""
    figure, axes = figure_of(2, 1, 3.6, sharex=True, height_ratios=(2, 1))
    for i, run in enumerate(runs):
        table = run.statistics
        time = 1e3 * table["time_s"]
        if run.in_blood:
            axes[0, 0].plot(time, table["outflow_mL_per_s"],
                            color=colour_of(i))
        axes[1, 0].plot(time, table["ventricular_pressure_Pa"] / 1e3,
                        color=colour_of(i))
    axes[0, 0].axhline(0, color="#888", linewidth=.8)
    axes[0, 0].set_ylabel("flow to the atrium, mL/s")
    axes[1, 0].set_ylabel("pressure, kPa")
    axes[1, 0].set_xlabel("time, ms")
    return encoded(figure)


def volume_past_leaflets(table):
    """Volume (mL) that has passed the leaflets: out of the tube and drained
    from films, less what the leaflets have swept."""
    return (table["outflow_volume_mL"] - table["swept_volume_mL"] +
            table.get("drained_volume_mL", 0.))


def leak_figure(runs):
    """Volume that has passed the leaflets over time."""
    figure, axes = figure_of()
    for i, run in enumerate(runs):
        if not run.in_blood:
            continue
        axes[0, 0].plot(1e3 * run.statistics["time_s"],
                        volume_past_leaflets(run.statistics),
                        color=colour_of(i))
    axes[0, 0].set_ylabel("volume past the leaflets, mL")
    axes[0, 0].set_xlabel("time, ms")
    axes[0, 0].set_ylim(bottom=min(0, axes[0, 0].get_ylim()[0]))
    return encoded(figure)


def chordae_figure(runs):
    """Sums of the forces of the four classes of chordae."""
    figure, axes = figure_of(2, 2, 3.8, sharex=True, sharey=True)
    for ax, (name, title) in zip(axes.flat, CLASSES):
        for i, run in enumerate(runs):
            table = run.statistics
            ax.plot(1e3 * table["time_s"], table[f"chordae_{name}_N"],
                    color=colour_of(i))
        ax.set_title(title, fontsize=9)
    for ax in axes[:, 0]:
        ax.set_ylabel("force, N")
    for ax in axes[1]:
        ax.set_xlabel("time, ms")
    return encoded(figure)


def time_figure(runs, name, title, bottom=0):
    """One column of the statistics over time, of the runs that have it."""
    figure, axes = figure_of(height=2.6)
    for i, run in enumerate(runs):
        if name not in run.statistics:
            continue
        axes[0, 0].plot(1e3 * run.statistics["time_s"], run.statistics[name],
                        color=colour_of(i))
    axes[0, 0].set_ylabel(title)
    axes[0, 0].set_xlabel("time, ms")
    axes[0, 0].set_ylim(bottom=bottom)
    return encoded(figure)


def gap_figure(runs):
    """The widest way through the valve over time, and what counts as shut."""
    figure, axes = figure_of(height=2.6)
    for i, run in enumerate(runs):
        table = run.statistics
        axes[0, 0].plot(1e3 * table["time_s"], table["widest_path_mm"],
                        color=colour_of(i))
        axes[0, 0].axhline(run.shut_width, color=colour_of(i),
                           linewidth=.8, linestyle=":")
    axes[0, 0].set_ylabel("widest way through, mm")
    axes[0, 0].set_xlabel("time, ms")
    axes[0, 0].set_ylim(bottom=0)
    return encoded(figure)


def is_finite(value):
    """Whether a figure of a summary is a number."""
    return value is not None and bool(numpy.isfinite(value))
