"""Findings of the study of chapter 4 on made-up runs: those that show what the
reference work found pass, and none passes when all cases are the same run."""

import sys
import types

import numpy

from coapt_report import findings

failures = 0


def check(what, condition):
    """Reports one assertion."""
    global failures
    failures += not condition
    print(what + (": ok" if condition else ": FAILED"))


def run(speed=.1, last_flow=0., edge=-8., **figures):
    """A made-up run; figures override those of a healthy valve."""
    summary = {"sealed": True, "leak_mL_per_s": .1, "bulging_volume_mL": .01,
               "coaptation_height_anterior_mm": 4.,
               "coaptation_height_posterior_mm": 5., "stress_mean_kPa": 55.,
               "coaptation_pressure_max_kPa": 18., "gaps": {"number": 0},
               "coaptation_belt_continuous": True,
               "widest_path": {"width_mm": .2, "x_mm": 9.}}
    summary.update(figures)
    statistics = {"time_s": numpy.array([0., .05, .1]),
                  "outflow_mL_per_s": numpy.array([0., 150., last_flow]),
                  "velocity_max_m_per_s": numpy.array([0., 1., speed]),
                  "ventricular_pressure_Pa": numpy.array([0., 8e3, 13e3])}
    table = {"right_mm": numpy.array([0., 0., 1., 1.]),
             "up_mm": numpy.array([0., -9., 0., -9.]),
             "z_mm": numpy.array([0., edge, 0., edge])}
    return types.SimpleNamespace(
        summary=summary, statistics=statistics, table=lambda name: table,
        parameters={"Fluid/Density": "1060"})


def torn(gaps=((9., 13.),), way=10.):
    """A made-up run with torn chordae: where its belt has gaps and how long
    they are, and where the widest way is."""
    places = {f"gap_{i + 1}": {"x_mm": x, "length_mm": length}
              for i, (x, length) in enumerate(gaps)}
    return run(sealed=False, speed=4., last_flow=20., leak_mL_per_s=12.,
               coaptation_belt_continuous=not gaps,
               gaps={"number": len(gaps), **places},
               widest_path={"width_mm": .8, "x_mm": way})


def cases():
    """One run of each case as the reference work describes it."""
    return {
        "healthy": run(),
        "no_chordae": run(sealed=False, edge=6., bulging_volume_mL=2.),
        "regurgitation": torn(),
        "prolapse": run(bulging_volume_mL=.2, stress_mean_kPa=66.,
                        coaptation_height_anterior_mm=3.,
                        coaptation_pressure_max_kPa=25.)}


found = findings.case_findings(cases())
check("eleven findings of the four cases", len(found) == 11)
check("all pass where they should", all(f.passed for f in found))
same = findings.case_findings({name: run() for name in cases()})
check("on one and the same run only that it seals and the flow stops",
      [f.passed for f in same] == [True, False, True] + [False] * 8)
prolapse = cases()["prolapse"]
for what, healthy, passed in (
        ("a leak is noticed", run(last_flow=30., sealed=False),
         [False, True, False]),
        ("so is a belt that is broken", run(coaptation_belt_continuous=False),
         [False, True, True]),
        ("a valve that bulges half as much as a prolapse is flat",
         run(bulging_volume_mL=.1), [True, True, True]),
        ("one that bulges more is not", run(bulging_volume_mL=.11),
         [True, False, True])):
    check(what, [f.passed for f in findings.healthy_findings(
        healthy, prolapse)] == passed)
check("nor is one that bulges much, whatever the prolapse does",
      [findings.flatness(run(bulging_volume_mL=.31), other).passed
       for other in (run(bulging_volume_mL=2.), None)] == [False, False])
check("the longest gap and the widest way are to be where chordae are torn",
      [findings.regurgitation_findings(case, run())[0].passed for case in (
          torn(((-9., 1.), (9., 13.))), torn(((-9., 3.), (9., 1.))),
          torn(((-9., 13.),)), torn(way=-10.), torn(()))]
      == [True, False, False, False, False])
missing = findings.chapter4({"healthy": run()})
check("what was not run does not pass",
      [f.word for f in missing] ==
      ["pass", "not run", "pass"] + ["not run"] * 5)

table = {"solid_tets": [2e4, 8e4], "stress_mean_kPa": [93., 92.8],
         "strain_mean": [.25, .26], "stress_mean_kPa_change": [0., -.002],
         "strain_mean_change": [0., .04]}
check("meshes of the leaflets",
      [f.passed for f in findings.mesh_findings(table)] == [True, False])
leaks = {"fluid_cells": [1e4, 6e4], "leak_mL_per_s": [23., -.1]}
check("meshes of the blood",
      [f.passed for f in findings.leakage_findings(leaks)] == [False, True])
sys.exit(1 if failures else 0)
