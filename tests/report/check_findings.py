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
               "widest_path": {"width_mm": .2}}
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


def cases():
    """One run of each case as the reference work describes it."""
    return {
        "healthy": run(),
        "no_chordae": run(sealed=False, edge=6., bulging_volume_mL=2.),
        "regurgitation": run(sealed=False, speed=4., last_flow=20.,
                             leak_mL_per_s=12., gaps={"number": 1}),
        "prolapse": run(bulging_volume_mL=.2, stress_mean_kPa=66.,
                        coaptation_height_anterior_mm=3.,
                        coaptation_pressure_max_kPa=25.)}


found = findings.case_findings(cases())
check("eleven findings of the four cases", len(found) == 11)
check("all pass where they should", all(f.passed for f in found))
same = findings.case_findings({name: run() for name in cases()})
check("none but those of the healthy valve passes on one and the same run",
      [f.passed for f in same] == [True] * 3 + [False] * 8)
leaking = findings.healthy_findings(run(last_flow=30., sealed=False))
check("a leak is noticed", [f.passed for f in leaking] == [False, True, False])
missing = findings.chapter4({"healthy": run()})
check("what was not run does not pass",
      [f.word for f in missing] == ["pass"] * 3 + ["not run"] * 5)

table = {"solid_tets": [2e4, 8e4], "stress_mean_kPa": [93., 92.8],
         "strain_mean": [.25, .26], "stress_mean_kPa_change": [0., -.002],
         "strain_mean_change": [0., .04]}
check("meshes of the leaflets",
      [f.passed for f in findings.mesh_findings(table)] == [True, False])
leaks = {"fluid_cells": [1e4, 6e4], "leak_mL_per_s": [23., -.1]}
check("meshes of the blood",
      [f.passed for f in findings.leakage_findings(leaks)] == [False, True])
sys.exit(1 if failures else 0)
