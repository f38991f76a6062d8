"""Puts the page together."""

import html
import os

from . import colours, figures, pictures, plots, views

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
        name = f"<div>{html.escape(run.label)}</div>"
        boxes.append(
            f'<div class="verdict{" sealed" if sealed else ""}">{name}'
            f'<div class="word">{"Sealed" if sealed else "Not sealed"}</div>'
            f"<p>{html.escape(text)}</p>{key_figures(run)}</div>")
    return '<div class="verdicts">' + "\n".join(boxes) + "</div>"


def key_figures(run):
    """The figures that belong to the verdict."""
    return '<dl class="key">' + "".join(
        f"<div><dt>{html.escape(row.title)}</dt>"
        f"<dd>{row.text(run)} {row.unit}</dd></div>"
        for row in figures.KEY_FIGURES) + "</dl>"


def picture_section(runs, ranges):
    """Pictures of the open and the closed valves."""
    parts = ['<h2 id="pictures">The valve</h2>',
             '<p class="soft">Seen from the atrium, the anterior leaflet is '
             "at the top and the left commissure (segments A1, P1) at the "
             "left.</p>",
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
    """What flows, and when the valve shuts."""
    return ('<h2 id="flow">Flow and closure</h2>' + run_colours(runs) +
            '<div class="figures">' +
            figure(plots.flow_figure(runs),
                   "Flow out at the atrial end, and the pressure of the "
                   "ventricle that drives it.") +
            figure(plots.leak_figure(runs),
                   "Blood that has passed the valve: the outflow less what "
                   "the leaflets push ahead of them. It stays level once the "
                   "valve is sealed.") +
            figure(plots.gap_figure(runs),
                   "Width of the widest way from ventricle to atrium, beyond "
                   "the clearance of contact. Below the dotted line it counts "
                   "as shut.") + "</div>")


def streamline_section(runs):
    """Where the blood goes."""
    parts = ['<h3>Streamlines</h3><div class="pictures">']
    for run in runs:
        for caption, source, top in pictures.streamline_pictures(run):
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
               "annulus, on its atrial side.") + "</div>")


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
                 run.text("parameters-as-read.prm")),
                ("All parameters in use", run.text("parameters.prm")),
                ("Where the time went", run.timings)):
            if text:
                parts.append(f"<details><summary>{title}</summary>"
                             f"<pre>{html.escape(text)}</pre></details>")
    return "\n".join(parts)


def page(runs, title):
    """The whole report as HTML."""
    ranges = colours.common_ranges(runs)
    sections = [verdict_section(runs), picture_section(runs, ranges),
                view_section(runs, ranges), flow_section(runs), streamline_section(runs),
                load_section(runs), figure_section(runs),
                set_up_section(runs)]
    links = (("pictures", "The valve"), ("turn", "3D"), ("flow", "Flow"),
             ("loads", "Loads"), ("figures", "Figures"),
             ("set-up", "Set-up"))
    navigation = "".join(f'<a href="#{name}">{text}</a>'
                         for name, text in links)
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
