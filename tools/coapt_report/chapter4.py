"""python3 -m coapt_report.chapter4 FOLDER: the report of the study of chapter 4
and the table of its findings, from what has been run so far into the folders
healthy, regurgitation, prolapse, no_chordae, fluid_mesh and leaflet_mesh. Exit
code 1 if a finding has not come out or was not computed."""

import os
import sys

from . import findings
from .page import page
from .run import OutputError, Run

CASES = (("healthy", "Healthy"), ("regurgitation", "Regurgitation"),
         ("prolapse", "Prolapse"), ("no_chordae", "No chordae"))


def cases_in(folder):
    """The cases that have run to their end, by name."""
    runs = {}
    for name, label in CASES:
        try:
            runs[name] = Run(os.path.join(folder, name), label)
        except OutputError as error:
            print(f"not in the report: {error}", file=sys.stderr)
    return runs


def table_in(folder, name):
    """The table of a study; None if there is none."""
    table = os.path.join(folder, name, "study.csv")
    return table if os.path.isfile(table) else None


def markdown(found):
    """The table of findings as text."""
    lines = ["| case | finding | measured | |", "|---|---|---|---|"]
    lines += [f"| {f.case} | {f.text} | {f.measured} | {f.word} |"
              for f in found]
    return "\n".join(lines) + "\n"


def main():
    """Writes report.html and findings.md; returns the exit code."""
    folder = sys.argv[1]
    runs = cases_in(folder)
    found = findings.chapter4(runs, table_in(folder, "fluid_mesh"),
                              table_in(folder, "leaflet_mesh"))
    with open(os.path.join(folder, "findings.md"), "w",
              encoding="utf-8") as file:
        file.write(markdown(found))
    print(markdown(found), end="")
    if runs:
        report = os.path.join(folder, "report.html")
        text = page(list(runs.values()),
                    "Four valves: the study of chapter 4", found)
        with open(report, "w", encoding="utf-8") as file:
            file.write(text)
        print(os.path.abspath(report))
    return 0 if all(f.passed for f in found) else 1


if __name__ == "__main__":
    sys.exit(main())
