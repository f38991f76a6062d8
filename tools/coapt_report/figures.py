"""The table of figures, and the verdict in words."""

from .plots import is_finite


class Row:
    """A row of the table: title, key in the summary ("a/b" for nested ones),
    unit, format and what it means."""

    def __init__(self, title, key, unit="", pattern="{:.3g}", factor=1.):
        self.title, self.key, self.unit = title, key, unit
        self.pattern, self.factor = pattern, factor

    def value(self, run):
        """The number of a run; None if it has none."""
        value = run.summary
        for name in self.key.split("/"):
            if not isinstance(value, dict) or name not in value:
                return None
            value = value[name]
        return value

    def text(self, run):
        """What the table shows for a run."""
        value = self.value(run)
        if isinstance(value, bool):
            return "yes" if value else "no"
        if isinstance(value, str):
            return value
        if not is_finite(value):
            return "–"
        scaled = value if self.factor == 1 else value * self.factor
        return self.pattern.format(scaled)


GROUPS = (
    ("Closure", (
        Row("Closing time", "closing_time_s", "ms", "{:.0f}", 1e3),
        Row("Leak after closure", "leak_mL_per_s", "mL/s", "{:.2f}"),
        Row("… through gaps", "leak_through_gaps_mL_per_s", "mL/s", "{:.2f}"),
        Row("… through the tissue (numerical)", "leak_through_tissue_mL_per_s",
            "mL/s", "{:.2f}"),
        Row("… drained from films (numerical)", "leak_drained_mL_per_s",
            "mL/s", "{:.2f}"),
        Row("Flow past the leaflets at the first plane",
            "planes/plane_1/flow_less_swept_mL_per_s", "mL/s", "{:.2f}"),
        Row("… at the second plane",
            "planes/plane_2/flow_less_swept_mL_per_s", "mL/s", "{:.2f}"),
        Row("Regurgitant volume", "regurgitant_volume_mL", "mL", "{:.3f}"),
        Row("Closing volume", "closing_volume_mL", "mL"),
        Row("Largest flow to the atrium", "flow_peak_mL_per_s", "mL/s",
            "{:.0f}"),
        Row("Widest way through, beyond contact", "widest_path/width_mm",
            "mm", "{:.2f}"),
        Row("… where", "widest_path/place"),
        Row("Orifice seen along the axis", "orifice/seen_area_mm2", "mm²",
            "{:.2f}"),
        Row("… largest disc in it", "orifice/largest_disc_mm", "mm",
            "{:.2f}"),
        Row("Orifice that the leak belongs to", "orifice/effective_area_mm2",
            "mm²", "{:.2f}"),
        Row("… over the orifice seen", "orifice/effective_over_seen_area", "",
            "{:.2f}"),
        Row("Largest Reynolds number at the annulus", "reynolds_peak", "",
            "{:,.0f}"))),
    ("Coaptation", (
        Row("Gaps in the belt", "gaps/number", "", "{:.0f}"),
        Row("Belt unbroken from commissure to commissure",
            "coaptation_belt_continuous"),
        Row("Area of coaptation", "coaptation_area_mm2", "mm²", "{:.0f}"),
        Row("Height in contact, anterior (mean)",
            "coaptation_height_anterior_mm", "mm", "{:.1f}"),
        Row("Height in contact, posterior (mean)",
            "coaptation_height_posterior_mm", "mm", "{:.1f}"),
        Row("Force of coaptation", "coaptation_force_N", "N", "{:.2f}"),
        Row("… carried by contact itself", "contact_fraction", "%", "{:.0f}",
            100),
        Row("Largest pressure of coaptation", "coaptation_pressure_max_kPa",
            "kPa", "{:.0f}"))),
    ("Leaflets", (
        Row("Bulging volume", "bulging_volume_mL", "mL"),
        Row("Mean von Mises stress", "stress_mean_kPa", "kPa", "{:.1f}"),
        Row("Mean of the largest principal stress",
            "principal_stress_mean_kPa", "kPa", "{:.1f}"),
        Row("Mean of the largest strain", "strain_mean", "", "{:.3f}"),
        Row("Force on the annulus", "annulus_force_N", "N", "{:.2f}"),
        Row("… along the axis, towards the atrium", "annulus_force_z_N", "N",
            "{:.2f}"))),
    ("Largest force of a single chorda", (
        Row("Anterior primary", "chordae_peak_N/anterior_primary", "N",
            "{:.2f}"),
        Row("Posterior primary", "chordae_peak_N/posterior_primary", "N",
            "{:.2f}"),
        Row("Anterior secondary", "chordae_peak_N/anterior_secondary", "N",
            "{:.2f}"),
        Row("Posterior secondary", "chordae_peak_N/posterior_secondary", "N",
            "{:.2f}"))),
    ("Computation", (
        Row("Fluid cells", "fluid_cells", "", "{:,.0f}"),
        Row("Tetrahedra of the leaflets", "solid_tets", "", "{:,.0f}"),
        Row("Time steps", "steps", "", "{:,.0f}"),
        Row("Core hours", "core_hours", "h", "{:.2f}"),
        Row("Error of the energy balance", "energy_error_relative", "%",
            "{:.2f}", 100),
        Row("Energy that adaptation has changed", "work_of_adaptation_relative",
            "%", "{:.2f}", 100))))


KEY_FIGURES = (
    Row("Leak", "leak_mL_per_s", "mL/s", "{:.2f}"),
    Row("Widest way through", "widest_path/width_mm", "mm", "{:.2f}"),
    Row("Contact height, anterior", "coaptation_height_anterior_mm", "mm",
        "{:.1f}"),
    Row("Contact height, posterior", "coaptation_height_posterior_mm", "mm",
        "{:.1f}"),
    Row("Bulging", "bulging_volume_mL", "mL", "{:.2f}"),
    Row("Mean stress", "stress_mean_kPa", "kPa", "{:.0f}"))


def verdict(run):
    """Whether the valve is sealed, and a sentence or two about it."""
    summary = run.summary
    sealed = bool(summary["sealed"])
    leak = (leak_text(summary["leak_mL_per_s"],
                      summary.get("leak_through_gaps_mL_per_s"))
            if run.in_blood else "Closed by pressure alone, without blood.")
    path = summary["widest_path"]
    if sealed:
        text = (f"Shut from {1e3 * summary['closing_time_s']:.0f} ms on. "
                f"{leak} At {1e3 * summary['end_time_s']:.0f} ms "
                f"the leaflets meet over "
                f"{summary['coaptation_area_mm2']:.0f} mm².")
    elif path["width_mm"] < path.get("shut_below_mm", 0):
        drained = summary.get("leak_drained_mL_per_s", 0)
        text = (f"{leak} It is shut, but that is more than counts as tight; "
                f"{drained:.2f} mL/s drain from films between the leaflets.")
    else:
        text = (f"{leak} The widest way through the valve is "
                f"{path['width_mm']:.2f} mm beyond contact, at the "
                f"{path['place']} ({path['x_mm']:.1f}, {path['y_mm']:.1f}, "
                f"{path['z_mm']:.1f} mm).")
    return sealed, text


def leak_text(leak, gaps):
    """The leak (mL/s) in words, and what of it goes through gaps."""
    if not is_finite(leak):
        return "The run is too short to tell the leak."
    if abs(leak) < .005:
        return "No leak (below 0.01 mL/s)."
    if leak < 0:
        return f"No leak ({-leak:.2f} mL/s flow back)."
    real = (f", {gaps:.2f} mL/s of it through gaps" if is_finite(gaps)
            else "")
    return f"The leak is {leak:.2f} mL/s{real}."
