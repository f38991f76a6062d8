"""Puts the page together."""

import html
import os

from . import closure, colours, figures, pictures, plots, views

HERE = os.path.dirname(__file__)


def text_of(name):
    """A file of this package."""
    with open(os.path.join(HERE, name), encoding="utf-8") as file:
        return file.read()


def figure(source, caption, alternative=None):
    """A picture with its caption."""
    return (f'<figure><img src="{source}" '
            f'alt="{html.escape(alternative or caption)}">'
            f"<figcaption>{html.escape(caption)}</figcaption></figure>")


def table(header, rows):
    """A table; rows of one entry are titles of groups."""
    lines = ['<div class="table"><table><thead><tr>' +
             "".join(f"<th>{html.escape(h)}</th>" for h in header) +
             "</tr></thead><tbody>"]
    for row in rows:
        if len(row) == 1:
            lines.append(f'<tr class="group"><td colspan="{len(header)}">'
                         f"{html.escape(row[0])}</td></tr>")
        else:
            lines.append("<tr>" + "".join(
                f"<td>{html.escape(entry)}</td>" for entry in row) + "</tr>")
    lines.append("</tbody></table></div>")
    return "\n".join(lines)


def legend(field, top, attributes=""):
    """The colours of a field."""
    unit = f" {field.unit}" if field.unit else ""
    return (f'<div class="legend" {attributes}>'
            f"<div>{html.escape(field.title)}{unit and ',' + unit}</div>"
            f'<div class="bar" style="background: {field.gradient()}"></div>'
            f'<div class="ends"><span>0</span><span>{top:g} and more</span>'
            "</div></div>")


def verdict_section(runs):
    """Sealed or not, for each run."""
    boxes = []
    for run in runs:
        sealed, text = figures.verdict(run)
        belt = " ".join([closure.belt_sentence(run)] +
                        closure.gap_sentences(run))
        name = f"<div>{html.escape(run.label)}</div>"
        boxes.append(
            f'<div class="verdict{" sealed" if sealed else ""}">{name}'
            f'<div class="word">{"Sealed" if sealed else "Not sealed"}</div>'
            f"<p>{html.escape(text)}</p>"
            f'<p class="belt">{html.escape(belt)}</p>{key_figures(run)}</div>')
    return '<div class="verdicts">' + "\n".join(boxes) + "</div>"


def key_figures(run):
    """The figures that belong to the verdict."""
    return '<dl class="key">' + "".join(
        f"<div><dt>{html.escape(row.title)}</dt>"
        f"<dd>{row.text(run)} {row.unit}</dd></div>"
        for row in figures.KEY_FIGURES
        if row.value(run) is not None or run.in_blood) + "</dl>"


def finding_section(findings):
    """What a study was to find, and whether it came out."""
    if not findings:
        return ""
    rows = "\n".join(
        f'<tr><td>{html.escape(f.case)}</td><td class="text">'
        f'{html.escape(f.text)}</td><td class="text">'
        f'{html.escape(f.measured)}</td>'
        f'<td class="{f.word}">{f.word}</td></tr>' for f in findings)
    return ('<h2 id="findings">Findings of the reference work</h2>'
            '<div class="table"><table><thead><tr><th>Case</th>'
            '<th class="text">Finding</th><th class="text">Measured</th>'
            f"<th></th></tr></thead><tbody>{rows}</tbody></table></div>")


def picture_section(runs, ranges):
    """Pictures of the open and the closed valves."""
    parts = ['<h2 id="pictures">The valve</h2>',
             '<p class="soft">Colours tell stress and strain of the valve at '
             "rest, open, where they are those of its prestretch, and at the "
             "end of the run. Seen from the atrium, the anterior leaflet is at "
             "the top and the left commissure (segments A1, P1) at the left. "
             "The cut shows the left half, with the anterior leaflet at the "
             "right.</p>",
             '<div class="legends">',
             legend(colours.STRESS, ranges[colours.STRESS]),
             legend(colours.STRAIN, ranges[colours.STRAIN]), "</div>"]
    for run in runs:
        if len(runs) > 1:
            parts.append(f"<h3>{html.escape(run.label)}</h3>")
        parts.append('<div class="pictures">' + "\n".join(
            figure(source, caption, f"{run.label}: {caption}")
            for caption, source in pictures.valve_pictures(run, ranges)) +
            "</div>")
    return "\n".join(parts)


def view_section(runs, ranges):
    """The interactive views."""
    options = "".join(
        f'<option value="{field.name}">{html.escape(field.title)}</option>'
        for field in ranges) + '<option value="">Plain</option>'
    canvases = "\n".join(
        f'<figure><canvas id="view-{i}" role="img" aria-label='
        f'"{html.escape(run.label)}, to be turned"></canvas><figcaption>'
        f'{html.escape(run.label)}, <span id="view-{i}-time"></span>'
        "</figcaption></figure>" for i, run in enumerate(runs))
    legends = "".join(
        legend(field, top, f'hidden data-field="{field.name}"').replace(
            'class="legend"', 'class="legend legend-3d"')
        for field, top in ranges.items())
    return f"""<h2 id="turn">Turn it yourself</h2>
<p class="soft">Drag to turn, wheel or two fingers to zoom.</p>
<div class="controls">
<button data-look="atrium">From the atrium</button>
<button data-look="side">Oblique</button>
<button data-look="front">From the posterior side</button>
<button data-look="ventricle">From the ventricle</button>
<label>Colour <select id="view-field">{options}</select></label>
<label>Time <input id="view-time" type="range" min="0" max="1" step="any"
 value="1"></label>
<label>Cut <input id="view-cut" type="range" min="0" max="2" step="any"
 value="0"></label>
<label><input id="view-chordae" type="checkbox" checked> Chordae</label>
</div>
<div class="legends">{legends}</div>
<div id="views">{canvases}</div>
<script type="application/json" id="view-data">{
    views.view_data(runs, ranges)}</script>"""


def run_colours(runs):
    """Which colour a run has in the diagrams."""
    if len(runs) == 1:
        return ""
    return '<ul class="runs">' + "".join(
        f'<li><span style="background: {plots.colour_of(i)}"></span>'
        f"{html.escape(run.label)}</li>" for i, run in enumerate(runs)) + "</ul>"


def flow_section(runs):
    """What flows, where there is blood, and when the valve shuts."""
    flow = ""
    if any(run.in_blood for run in runs):
        flow = (figure(plots.flow_figure(runs),
                       "Flow out at the atrial end, and the pressure of the "
                       "ventricle that drives it.") +
                figure(plots.leak_figure(runs),
                       "Blood that has passed the valve: the outflow and what "
                       "is drained from films between the leaflets, less "
                       "what the leaflets push ahead of them. It stays level "
                       "once the valve is sealed."))
    return ('<h2 id="flow">Flow and closure</h2>' + run_colours(runs) +
            '<div class="figures">' + flow +
            figure(plots.gap_figure(runs),
                   "Width of the widest way from ventricle to atrium, beyond "
                   "the clearance of contact. Below the dotted line it counts "
                   "as shut.") +
            (figure(plots.time_figure(runs, "orifice_area_mm2",
                                      "open area, mm²"),
                    "What the leaflets leave open, seen along the axis.")
             if any("orifice_area_mm2" in run.statistics for run in runs)
             else "") + "</div>")


def gap_map(run, name):
    """How far each place is from the other leaflet."""
    return figure(
        closure.map_figure(run, "gap", "gap, mm", 1e-3, "viridis_r", 0, 2),
        f"{name}Gap between each place and what faces it (blank: nothing "
        "within 10 mm).")


def slip_figure(run, name):
    """How far places have slid, if that is known."""
    table = run.table("contact_map.csv")
    if "slip_mm" not in table:
        return ""
    top = max(.1, colours.round_up(float(table["slip_mm"].max())))
    return figure(
        closure.map_figure(run, "slip", "slip, mm", 1e-3, "YlOrBr", 0, top),
        f"{name}How far each place has slid on the other leaflet.")


def section_figures(runs):
    """The leaflets cut at all places."""
    return "".join(
        figure(closure.section_figure(runs, x),
               "In the middle." if x == 0 else
               f"{abs(x):.1f} mm to the {'left' if x < 0 else 'right'} of it.")
        for x in closure.section_places(runs))


def coaptation_section(runs):
    """Where and how firmly the leaflets meet."""
    runs = [run for run in runs if run.has("contact_map.vtu")]
    if not runs:
        return ""
    top = closure.pressure_range(runs)
    parts = ['<h2 id="coaptation">Coaptation</h2>',
             legend(colours.TRACTION, top)]
    for run in runs:
        name = f"{run.label}. " if len(runs) > 1 else ""
        sentences = closure.gap_sentences(run)
        last = run.statistics["time_s"][-1]
        parts.append('<div class="pictures">' + "".join(
            figure(source, name + caption)
            for caption, source in closure.belt_pictures(run, top)) +
            "</div>")
        parts.append('<div class="figures wide">' + figure(
            closure.map_figure(run, "coaptation_pressure",
                               "pressure, kPa", 1e3, "BuPu", 0, top),
            f"{name}Pressure between the leaflets, mean of the last 20 ms, on "
            "the leaflet unrolled from its open shape. The middle is the "
            "anterior leaflet, both ends the posterior one. " +
            " ".join(sentences)) + figure(
            closure.map_figure(run, "first_contact", "time, ms", 1e-3,
                               "viridis", 0, 1e3 * last),
            f"{name}When each place first touched (blank: never).") +
            gap_map(run, name) + slip_figure(run, name) + "</div>")
    parts += [
        run_colours(runs), '<div class="figures">',
        figure(closure.belt_figure(runs),
               "The belt by position: tissue in contact (full lines) and "
               "apposition as an echocardiogram shows it (dotted)."),
        figure(closure.distribution_figure(runs),
               "Share of the belt where the pressure exceeds t: all that "
               "presses (full) and contact alone (dotted)."),
        "</div>",
        "<h3>The leaflets cut across, closed and open (dashed)</h3>",
        '<div class="figures">',
        section_figures(runs),
        "</div>",
        "<h3>Coaptation length by segment, mm</h3>",
        table([""] + [text for run in runs for text in (
            f"{run.label}: contact" if len(runs) > 1 else "In contact",
            "least", "apposition")], closure.segment_rows(runs)),
        '<p class="soft">In contact: height of the tissue that presses on the '
        "other leaflet, mean over the segment and its least value. Apposition: "
        "length of the closed leaflet beside the other one, pressed or "
        "not.</p>"]
    return "\n".join(parts)


def streamline_section(runs, times):
    """Where the blood goes, if there is any, at the given times (s)."""
    runs = [run for run in runs if run.in_blood]
    if not runs:
        return ""
    parts = ['<h3>Streamlines</h3><div class="pictures">']
    for run in runs:
        for caption, source, top in pictures.streamline_pictures(run, times):
            name = f"{run.label}. {caption}" if len(runs) > 1 else caption
            parts.append("<div>" + figure(source, name, f"Flow, {name}") +
                         legend(colours.SPEED, top) + "</div>")
    return "\n".join(parts) + "</div>"


def load_section(runs):
    """What carries the load."""
    return (
        '<h2 id="loads">Chordae, coaptation, bulging</h2>' +
        run_colours(runs) + '<div class="figures">' +
        figure(plots.chordae_figure(runs),
               "Forces of the chordae, summed over each class.") +
        figure(plots.time_figure(runs, "coaptation_force_N",
                                 "force of coaptation, N"),
               "Force with which the leaflets press on each other.") +
        figure(plots.time_figure(runs, "bulging_volume_mL",
                                 "bulging volume, mL"),
               "Volume between the leaflets and a surface that spans the "
               "annulus, on its atrial side.") +
        (figure(closure.chorda_figure(runs),
                "Largest force of each chorda: R and L right and left, P "
                "primary from the anterior middle on, S secondary.")
         if any(run.has("chordae.csv") for run in runs) else "") + "</div>" +
        ("<h3>Stress, strain and bulging by region</h3>" +
         table([""] + [run.label for run in runs], closure.region_rows(runs))
         if any("regions" in run.summary for run in runs) else ""))


def figure_section(runs):
    """The table of figures."""
    rows = []
    for title, group in figures.GROUPS:
        shown = [row for row in group
                 if any(row.value(run) is not None for run in runs)]
        if shown:
            rows.append((title,))
        for row in shown:
            unit = f", {row.unit}" if row.unit else ""
            rows.append([row.title + unit] + [row.text(run) for run in runs])
    header = [""] + [run.label for run in runs]
    return '<h2 id="figures">Figures</h2>' + table(header, rows)


def differences(runs):
    """Parameters in which runs differ, as rows of a table."""
    names = []
    for run in runs:
        names += [name for name in run.parameters if name not in names]
    rows = []
    for name in names:
        values = [run.parameters.get(name, "–") for run in runs]
        if len(set(values)) > 1 and not name.startswith("Output/"):
            rows.append([name] + values)
    return rows


def set_up_section(runs):
    """Parameters, versions, warnings, timings."""
    parts = ['<h2 id="set-up">Set-up and provenance</h2>']
    if len(runs) > 1 and differences(runs):
        parts += ["<h3>Parameters in which the runs differ</h3>",
                  table(["Parameter"] + [run.label for run in runs],
                        differences(runs))]
    for run in runs:
        parts.append(f"<h3>{html.escape(run.label)}</h3>")
        warnings = run.summary.get("warnings", [])
        parts.append("<p>" + ("Warnings:" if warnings else "No warnings.") +
                     "</p>")
        if warnings:
            parts.append("<ul>" + "".join(
                f"<li>{html.escape(warning)}</li>" for warning in warnings) +
                "</ul>")
        for title, text in (
                ("Versions and machine", "\n".join(run.provenance)),
                ("Parameter file as read",
                 run.parameters_as_read),
                ("All parameters in use", run.parameters_in_use),
                ("Where the time went", run.timings)):
            if text:
                parts.append(f"<details><summary>{title}</summary>"
                             f"<pre>{html.escape(text)}</pre></details>")
    return "\n".join(parts)


def page(runs, title, findings=(), times=()):
    """The whole report as HTML, with findings of a study, if there are some,
    and streamlines at the given times (s), or at those that are worth it."""
    ranges = colours.common_ranges(runs)
    sections = [verdict_section(runs), finding_section(findings),
                picture_section(runs, ranges), view_section(runs, ranges),
                coaptation_section(runs), flow_section(runs),
                streamline_section(runs, times), load_section(runs),
                figure_section(runs), set_up_section(runs)]
    links = (("findings", "Findings"), ("pictures", "The valve"),
             ("turn", "3D"), ("coaptation", "Coaptation"), ("flow", "Flow"),
             ("loads", "Loads"), ("figures", "Figures"),
             ("set-up", "Set-up"))
    navigation = " ".join(f'<a href="#{name}">{text}</a>'
                         for name, text in links
                         if any(f'id="{name}"' in part for part in sections))
    return f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none';
 img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'">
<meta name="viewport" content="width=device-width, initial-scale=1">
<link rel="icon" href="data:,">
<title>{html.escape(title)}</title>
<style>
{text_of("style.css")}</style>
</head>
<body>
<header>
<h1>{html.escape(title)}</h1>
<nav>{navigation}</nav>
</header>
<main>
{chr(10).join(sections)}
</main>
<footer>Written by coapt-report. The 3D view is drawn with three.js (MIT
licence). The file needs no network.</footer>
<script>
{text_of("viewer.min.js")}
</script>
</body>
</html>
"""
