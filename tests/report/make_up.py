"""Makes up the output of many runs from that of a few.

make_up.py study FOLDER RUN...: a study of six values of a parameter.
make_up.py chapter4 FOLDER RUN...: the four cases of chapter 4, with the figures
that the reference work found.
"""

import itertools
import json
import os
import shutil
import sys

CASES = {
    "healthy": {"sealed": True, "leak_mL_per_s": .1, "closing_time_s": 5e-4,
                "coaptation_belt_continuous": True, "gaps": {"number": 0},
                "bulging_volume_mL": .05},
    "regurgitation": {"sealed": False, "leak_mL_per_s": 12.},
    "prolapse": {"sealed": True, "leak_mL_per_s": .2, "closing_time_s": 6e-4,
                 "bulging_volume_mL": .2},
    "no_chordae": {"sealed": False, "leak_mL_per_s": 300.}}


def make_study(folder, runs):
    """Six runs with the parameters in the folder above them."""
    with open(os.path.join(runs[0], "parameters.prm"),
              encoding="utf-8") as file:
        parameters = file.read()
    with open(os.path.join(folder, "parameters.prm"), "w",
              encoding="utf-8") as file:
        file.write(parameters + "subsection Study\n"
                   "  set Parameter = Contact/Clearance\n"
                   "  set Values = 1, 1.1, 1.2, 1.3, 1.4, 1.5\nend\n")
    with open(os.path.join(folder, "study.csv"), "w",
              encoding="utf-8") as file:
        file.write("Contact/Clearance\n1\n1.1\n1.2\n1.3\n1.4\n1.5\n")
    for i, run in zip(range(6), itertools.cycle(runs)):
        shutil.copytree(run, os.path.join(folder, f"run_{i + 1}"))


def make_chapter4(folder, runs):
    """The four cases, whose summaries are changed."""
    for (case, figures), run in zip(CASES.items(), itertools.cycle(runs)):
        shutil.copytree(run, os.path.join(folder, case))
        name = os.path.join(folder, case, "summary.json")
        with open(name, encoding="utf-8") as file:
            summary = json.load(file)
        summary.update(figures)
        with open(name, "w", encoding="utf-8") as file:
            json.dump(summary, file)


shutil.rmtree(sys.argv[2], ignore_errors=True)
os.makedirs(sys.argv[2])
{"study": make_study, "chapter4": make_chapter4}[sys.argv[1]](
    sys.argv[2], sys.argv[3:])
