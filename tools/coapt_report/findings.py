"""The findings of chapter 4 of the reference work (Khaledian, 2023), each with
pass or fail from numbers of our runs.

A finding that compares cases passes if the sign is that of the reference work;
one that gives a figure passes if ours is as good."""

import numpy

from .plots import is_finite
from .run import read_csv

# Its tables 4.2 and 4.3.
STRESS_CHANGE, STRAIN_CHANGE = .009, .004
LEAKS = ((280e3, 22.6), (100e3, 23.9), (80e3, 26.2), (71e3, 36.8))

# Bounds of ours: a sealed valve leaks at most this (mL/s); a flat one bulges at
# most this (mL), and at most this share of what a prolapse does.
LARGEST_LEAK, LARGEST_BULGING, FLAT_SHARE = 1., .3, .5


class Finding:
    """What is to be found, what was measured, and whether it came out: True,
    False, or None if it was not computed."""

    def __init__(self, case, text, measured, passed):
        self.case, self.text = case, text
        self.measured = measured
        self.passed = None if passed is None else bool(passed)

    @property
    def word(self):
        """pass, fail or not run."""
        return {True: "pass", False: "fail", None: "not run"}[self.passed]


def value(run, key):
    """A figure of a run by its name, "a/b" for nested ones; nan if it has
    none."""
    found = run.summary
    for name in key.split("/"):
        found = found.get(name) if isinstance(found, dict) else None
    return float(found) if is_finite(found) else float("nan")


def free_edge_height(run):
    """Mean height of the free edge over the plane of the annulus (mm)."""
    table = run.table("contact_map.csv")
    lines = {}
    for right, up, z in zip(table["right_mm"], table["up_mm"], table["z_mm"]):
        lowest = lines.get(round(right, 3), (numpy.inf, 0.))
        lines[round(right, 3)] = min(lowest, (up, z))
    return float(numpy.mean([z for _, z in lines.values()]))


def contact_height(run):
    """Mean height in contact of both leaflets (mm)."""
    return .5 * (value(run, "coaptation_height_anterior_mm") +
                 value(run, "coaptation_height_posterior_mm"))


def last_flow(run):
    """Mean flow to the atrium over the last 5 ms, over the largest (-)."""
    table = run.statistics
    late = table["time_s"] >= table["time_s"][-1] - 5e-3
    flow = table["outflow_mL_per_s"]
    return float(flow[late].mean() / flow.max())


def flatness(healthy, prolapse):
    """Nearly flat: there is little bulging, of which a prolapse has more."""
    bulging = value(healthy, "bulging_volume_mL")
    if prolapse is None:
        return Finding("healthy", "nearly flat",
                       f"bulging {bulging:.3f} mL, prolapse –",
                       None if bulging <= LARGEST_BULGING else False)
    other = value(prolapse, "bulging_volume_mL")
    return Finding("healthy", "nearly flat",
                   f"bulging {bulging:.3f} mL, prolapse {other:.3f} mL",
                   bulging <= min(LARGEST_BULGING, FLAT_SHARE * other))


def healthy_findings(healthy, prolapse):
    """It seals with an unbroken belt, is nearly flat, and the flow falls to
    zero."""
    unbroken = healthy.summary["coaptation_belt_continuous"]
    return [
        Finding("healthy", "sealed",
                f"leak {value(healthy, 'leak_mL_per_s'):.2f} mL/s, belt of "
                f"coaptation {'unbroken' if unbroken else 'broken'}, gaps: "
                f"{value(healthy, 'gaps/number'):.0f}",
                healthy.summary["sealed"] and unbroken),
        flatness(healthy, prolapse),
        Finding("healthy", "the flow falls to zero",
                f"at the end {100 * last_flow(healthy):.1f} % of its peak",
                abs(last_flow(healthy)) <= .05)]


def no_chordae_findings(run):
    """The leaflets swing fully through."""
    height = free_edge_height(run)
    return [Finding("no chordae", "the leaflets swing fully through",
                    f"free edge {height:.1f} mm above the annulus, bulging "
                    f"{value(run, 'bulging_volume_mL'):.2f} mL",
                    height > 0 and not run.summary["sealed"])]


def longest_gap(run):
    """Length and x (mm) of the longest gap in the belt; zeros without gaps."""
    return max(((gap["length_mm"], gap["x_mm"])
                for name, gap in run.summary.get("gaps", {}).items()
                if name != "number"), default=(0., 0.))


def regurgitation_findings(run, healthy):
    """A gap in the belt where chordae are torn, which are R-P2 to R-P4 and R-S2,
    on the right (x > 0), a jet, a flow that does not stop."""
    gaps, (length, place) = value(run, "gaps/number"), longest_gap(run)
    way = value(run, "widest_path/x_mm")
    speed = float(run.statistics["velocity_max_m_per_s"][-1])
    pressure = float(run.statistics["ventricular_pressure_Pa"][-1])
    jet = (2 * pressure / float(run.parameters["Fluid/Density"]))**.5
    leak = value(run, "leak_mL_per_s")
    return [
        Finding("regurgitation", "a gap in the belt of coaptation, on the "
                "side of the torn chordae (x > 0)",
                f"{gaps:.0f} gaps, the longest {length:.1f} mm at x = "
                f"{place:.1f} mm; widest way "
                f"{value(run, 'widest_path/width_mm'):.2f} mm beyond contact, "
                f"at x = {way:.1f} mm" if gaps > 0 else "no gap",
                place > 0 and way > 0 and not run.summary["sealed"]),
        Finding("regurgitation", "a jet",
                f"{speed:.1f} m/s, Bernoulli's law allows {jet:.1f} m/s",
                speed >= .5 * jet),
        Finding("regurgitation", "the flow does not stop",
                f"leak {leak:.2f} mL/s, healthy "
                f"{value(healthy, 'leak_mL_per_s'):.2f} mL/s",
                leak > LARGEST_LEAK)]


def prolapse_findings(run, healthy):
    """Bulging, stress, thinner coaptation with higher pressure."""
    def compare(text, title, unit, ours, sign):
        mine, other = ours(run), ours(healthy)
        return Finding("prolapse", text,
                       f"{title} {mine:.3g} {unit}, healthy {other:.3g} "
                       f"{unit}", sign * (mine - other) > 0)
    return [
        compare("bulging", "bulging", "mL",
                lambda r: value(r, "bulging_volume_mL"), 1),
        compare("higher stress", "mean von Mises stress", "kPa",
                lambda r: value(r, "stress_mean_kPa"), 1),
        compare("thinner coaptation", "height in contact", "mm",
                contact_height, -1),
        compare("higher local pressure", "largest pressure", "kPa",
                lambda r: value(r, "coaptation_pressure_max_kPa"), 1)]


def mesh_findings(table):
    """Table 4.2: mean stress and strain on two meshes of the leaflet."""
    return [
        Finding("mesh of the leaflets",
                f"mean {name} changes by at most {100 * bound:.1f} %",
                f"{table[column][-2]:.4g} and {table[column][-1]:.4g} with "
                f"{table['solid_tets'][-2]:,.0f} and "
                f"{table['solid_tets'][-1]:,.0f} tetrahedra: "
                f"{100 * abs(table[column + '_change'][-1]):.2f} %",
                abs(table[column + "_change"][-1]) <= bound)
        for name, column, bound in (
            ("stress", "stress_mean_kPa", STRESS_CHANGE),
            ("strain", "strain_mean", STRAIN_CHANGE))]


def leakage_findings(table):
    """Table 4.3: the leak on meshes of the blood."""
    least = min(leak for _, leak in LEAKS)
    return [Finding("mesh of the blood",
                    f"{cells:,.0f} cells leak less than the best of the "
                    f"reference work, {least} mL/s",
                    f"{leak:.2f} mL/s", abs(leak) < least)
            for cells, leak in zip(table["fluid_cells"],
                                   table["leak_mL_per_s"])]


NOT_RUN = (
    ("healthy", "sealed, nearly flat, the flow falls to zero"),
    ("no_chordae", "the leaflets swing fully through"),
    ("regurgitation", "a gap in the belt, a jet, a flow that does not stop"),
    ("prolapse", "bulging, higher stress, thinner coaptation at a higher "
     "pressure"))


def case_findings(runs):
    """Findings of the four cases, of which some may be missing."""
    healthy, prolapse = runs.get("healthy"), runs.get("prolapse")
    found = {
        "healthy": lambda: healthy_findings(healthy, prolapse),
        "no_chordae": lambda: no_chordae_findings(runs["no_chordae"]),
        "regurgitation": lambda: regurgitation_findings(
            runs["regurgitation"], healthy),
        "prolapse": lambda: prolapse_findings(prolapse, healthy)}
    findings = []
    for name, text in NOT_RUN:
        if name in runs and healthy is not None:
            findings += found[name]()
        else:
            findings.append(Finding(name.replace("_", " "), text, "–", None))
    return findings


def chapter4(runs, fluid_table=None, leaflet_table=None):
    """All findings, from the cases by name and the tables (study.csv) of the
    two studies of meshes."""
    findings = case_findings(runs)
    findings += mesh_findings(read_csv(leaflet_table)) if leaflet_table else [
        Finding("mesh of the leaflets", "mean stress and strain hardly "
                "change", "–", None)]
    findings += leakage_findings(read_csv(fluid_table)) if fluid_table else [
        Finding("mesh of the blood", "leakage", "–", None)]
    return findings
