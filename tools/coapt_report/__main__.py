"""The command coapt-report."""

import argparse
import os
import sys

from . import pictures
from .page import page
from .run import OutputError, runs_of


def arguments():
    """Reads the command line."""
    parser = argparse.ArgumentParser(
        prog="coapt-report",
        description="Writes a report of one run of a valve, or of several "
        "side by side: an HTML file that opens in any browser and needs no "
        "network.")
    parser.add_argument("output", nargs="+",
                        help="output folder of a run or of a study, or the "
                        "parameter file that names it")
    parser.add_argument("-o", "--file", help="file to write (default: "
                        "report.html in the first output folder)")
    parser.add_argument("-t", "--title", help="title of the report")
    parser.add_argument("-l", "--label", action="append", default=[],
                        help="name of a run, in the order of the runs")
    parser.add_argument("--times", type=times_of, default=[], metavar="MS,...",
                        help="times (ms) at which to show streamlines, which "
                        "are also written as VTK files beside the report "
                        "(default: at the largest flow and, if the valve "
                        "leaks, at the end, without files)")
    return parser.parse_args()


def times_of(text):
    """The times (s) of a list of them in ms."""
    return [1e-3 * float(time) for time in text.split(",")]


def write_streamlines(runs, times, file):
    """Writes the streamlines of all runs in blood beside a report; returns the
    names of the files."""
    stem = os.path.splitext(os.path.abspath(file))[0] + "_streamlines"
    return [name for i, run in enumerate(runs) if run.in_blood
            for name in pictures.write_streamlines(
                run, times, stem if len(runs) == 1 else f"{stem}_{i + 1}")]


def common_folder(runs):
    """Where the report of runs goes unless it is said: beside the first run,
    or above it if it is one of a study."""
    folder = runs[0].folder
    above = os.path.dirname(folder)
    return above if os.path.isfile(
        os.path.join(above, "study.csv")) else folder


def main():
    """Writes the report; returns the exit code."""
    options = arguments()
    try:
        runs = [run for folder in options.output for run in runs_of(folder)]
    except OutputError as error:
        print(f"coapt-report: {error}", file=sys.stderr)
        return 2
    for run, label in zip(runs, options.label):
        run.label = label
    file = options.file or os.path.join(common_folder(runs), "report.html")
    title = options.title or (
        "Closure of a mitral valve" if len(runs) == 1 else
        f"Closure of {len(runs)} mitral valves")
    text = page(runs, title, times=options.times)
    with open(file, "w", encoding="utf-8") as stream:
        stream.write(text)
    if options.times:
        print("\n".join(write_streamlines(runs, options.times, file)))
    print(os.path.abspath(file))
    return 0


if __name__ == "__main__":
    sys.exit(main())
