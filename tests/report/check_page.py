"""Opens a report in headless Chromium and asserts that it is whole: no errors,
no network, every picture present, every 3D canvas drawn, text that fits, and
that it says what is in the output folders of its runs.

check_page.py REPORT --runs FOLDER... --pictures NUMBER [--findings NUMBER]
  [--shots FOLDER]
counts pictures and findings; writes screenshots into the folder, if given.
"""

import argparse
import base64
import json
import os
import re
import sys

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service

WIDTHS = (1280, 390)

# Elements that are wider than what they stand in, unless that scrolls.
TOO_WIDE = """
const wide = [];
for (const element of document.body.querySelectorAll('*')) {
  const style = getComputedStyle(element);
  if (element.closest('.table, pre, script, select, svg') || !element.offsetParent)
    continue;
  const box = element.getBoundingClientRect();
  if (box.right > innerWidth + 1 || element.scrollWidth > element.clientWidth + 1
      && element.clientWidth > 0 && style.display !== 'inline')
    wide.push(element.tagName + ' ' + element.className + ' ' +
              element.textContent.slice(0, 40));
}
return wide;
"""

# What is said of each finding.
FINDINGS = """
const title = document.getElementById('findings');
if (!title) return [];
return [...title.nextElementSibling.querySelectorAll('tbody tr')].map(
  (row) => row.lastElementChild.textContent);
"""

PICTURES = """
return [...document.images].map((image) => [image.alt, image.complete,
  image.naturalWidth]);
"""

# What the page says, by part.
CONTENT = """
const texts = (selector, root = document) =>
  [...root.querySelectorAll(selector)].map((e) => e.textContent.trim());
const title = [...document.querySelectorAll('h3')].find(
  (e) => e.textContent.startsWith('Coaptation length by segment'));
return {
  boxes: [...document.querySelectorAll('.verdict')].map((box) => ({
    word: texts('.word', box)[0], sealed: box.classList.contains('sealed'),
    belt: texts('.belt', box)[0],
    leak: texts('dl div', box).find((text) => text.startsWith('Leak'))})),
  segments: title ? [...title.nextElementSibling.querySelectorAll('tbody tr')]
    .map((row) => texts('td', row)) : [],
  captions: texts('figcaption'),
  setUp: [...document.querySelectorAll('#set-up ~ details')].map(
    (e) => [texts('summary', e)[0], texts('pre', e)[0]])};
"""

# Captions by how often they are there: once for each run, for each run in
# blood, or once.
OF_RUN = [f"{title}, {view}"
          for title in ("Open: Von Mises stress",
                        "Open: Largest principal logarithmic strain",
                        r"Von Mises stress at \d+ ms",
                        r"Largest principal logarithmic strain at \d+ ms")
          for view in ("from the atrium", "from the posterior side",
                       "cut through the middle")] + [
    r"(.*\. )?The anterior leaflet, seen from the posterior one: .*",
    r"(.*\. )?The posterior leaflet, seen from the anterior one: .*",
    r"(.*\. )?Pressure between the leaflets, .*",
    r"(.*\. )?When each place first touched .*",
    r"(.*\. )?Gap between each place and what faces it .*"]
OF_BLOOD = [r"Pressure of the blood at \d+ ms, cut through the middle: .*"]
OF_ALL = [r"The belt by position: .*", r"Share of the belt .*",
          r"In the middle\.", r"Flow out at the atrial end, .*",
          r"Width of the widest way .*", r"Forces of the chordae, .*",
          r"Force with which the leaflets press .*", r"Volume between .*"]
SEGMENTS = ("A1", "A2", "A3", "P1", "P2", "P3")

# Share of the pixels of each canvas that are not white.
CANVASES = """
return [...document.querySelectorAll('#views canvas')].map((canvas) => {
  const copy = document.createElement('canvas');
  copy.width = canvas.width; copy.height = canvas.height;
  const context = copy.getContext('2d');
  context.drawImage(canvas, 0, 0);
  const data = context.getImageData(0, 0, copy.width, copy.height).data;
  let drawn = 0;
  for (let i = 0; i < data.length; i += 4)
    if (data[i + 3] > 0 && Math.min(data[i], data[i + 1], data[i + 2]) < 240)
      ++drawn;
  return drawn / (data.length / 4);
});
"""

# Moves a control as a user does.
MOVE = """
const control = document.getElementById(arguments[0]);
control.value = arguments[1];
control.dispatchEvent(new Event('input'));
"""

failures = []


def check(condition, text):
    """Reports one assertion."""
    print(("ok: " if condition else "FAILED: ") + text)
    if not condition:
        failures.append(text)


def browser():
    """Headless Chromium with 3D graphics in software."""
    options = Options()
    for argument in ("--headless=new", "--no-sandbox", "--hide-scrollbars",
                     "--use-angle=swiftshader", "--disable-dev-shm-usage",
                     "--enable-unsafe-swiftshader"):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    options.binary_location = "/usr/bin/chromium"
    return webdriver.Chrome(
        service=Service("/usr/bin/chromedriver"), options=options)


def set_width(driver, width, height=900):
    """Sets the size of the page, also below that of the smallest window."""
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
        "width": width, "height": height, "deviceScaleFactor": 1,
        "mobile": width < 600})


def check_controls(driver):
    """The 3D view follows its controls, and all canvases together."""
    pictures = [driver.execute_script(CANVASES)]
    for control, value in (("view-time", 0), ("view-cut", 1),
                           ("view-field", "")):
        driver.execute_script(MOVE, control, value)
        pictures.append(driver.execute_script(CANVASES))
    driver.execute_script(
        "document.querySelector('[data-look=front]').click()")
    pictures.append(driver.execute_script(CANVASES))
    check(all(min(shares) > .02 for shares in pictures),
          "the valve stays in sight")
    check(all(before != after for before, after in zip(
        pictures, pictures[1:]) if before is not pictures[2]),
        f"time, cut and direction change the picture {pictures}")
    severe = [entry for entry in driver.get_log("browser")
              if entry["level"] == "SEVERE"]
    check(not severe, f"no errors while it is used {severe}")


def take_screenshots(driver, stem, width):
    """The whole page as pictures, one below the other: Chromium repeats what is
    taller than 8192 pixels."""
    height = driver.execute_script("return document.body.scrollHeight")
    driver.implicitly_wait(1)
    for i, top in enumerate(range(0, height, 8000)):
        shot = driver.execute_cdp_cmd("Page.captureScreenshot", {
            "format": "png", "captureBeyondViewport": True, "clip": {
                "x": 0, "y": top, "width": width, "scale": 1,
                "height": min(8000, height - top)}})
        with open(f"{stem}_{i + 1}.png", "wb") as stream:
            stream.write(base64.b64decode(shot["data"]))


def check_findings(driver, number):
    """There are so many findings, each with a word."""
    words = driver.execute_script(FINDINGS)
    check(len(words) == number and
          all(word in ("pass", "fail", "not run") for word in words),
          f"{len(words)} findings {words}")


def text_of(*path):
    """Text of a file without blanks around it; empty if there is none."""
    name = os.path.join(*path)
    if not os.path.isfile(name):
        return ""
    with open(name, encoding="utf-8") as file:
        return file.read().strip()


def check_verdicts(boxes, summaries):
    """Each box says what the summary of its run does."""
    check([(box["word"], box["sealed"]) for box in boxes] == [
        ("Sealed" if summary["sealed"] else "Not sealed", summary["sealed"])
        for summary in summaries],
        f"verdicts {[box['word'] for box in boxes]}")
    check(["unbroken" in box["belt"] for box in boxes] == [
        summary["coaptation_belt_continuous"] for summary in summaries],
        f"belts {[box['belt'] for box in boxes]}")
    leaks = [summary.get("leak_mL_per_s") for summary in summaries]
    check(all(leak is None or f"{leak:.2f} mL/s" in box["leak"]
              for box, leak in zip(boxes, leaks)),
          f"leaks {[box['leak'] for box in boxes]}")


def check_segments(rows, summaries):
    """The table of coaptation length has six segments with their figures."""
    check([row[0] for row in rows] == list(SEGMENTS),
          f"segments {[row[0] for row in rows]}")
    check([row[1:] for row in rows] == [
        [f"{summary['segments'][name][key]:.1f}" for summary in summaries
         for key in ("contact_height_mm", "contact_height_min_mm",
                     "apposition_mm")] for name in SEGMENTS],
        f"their figures {[row[1:4] for row in rows]}")


def check_captions(captions, n_runs, n_in_blood):
    """Every picture that is to be there is, by name."""
    for names, number in ((OF_RUN, n_runs), (OF_BLOOD, n_in_blood),
                          (OF_ALL, 1)):
        wrong = {name: found for name in names
                 if (found := sum(bool(re.fullmatch(name, caption))
                                  for caption in captions)) != number}
        check(not wrong, f"{len(names)} captions, {number} times each {wrong}")


def check_provenance(parts, runs):
    """Of each run, the revision and the parameters are there; those of a study
    are in the folder above."""
    revisions = [text_of(run, "coapt.log").splitlines()[0] for run in runs]
    shown = [text for title, text in parts if title == "Versions and machine"]
    check([text.splitlines()[0] for text in shown] == revisions and
          all(re.match(r"Coapt .*, revision \S+", line) for line in revisions),
          f"revisions {revisions}")
    folders = [os.path.dirname(run)
               if text_of(os.path.dirname(run), "study.csv") else run
               for run in runs]
    for title, name in (("Parameter file as read", "parameters-as-read.prm"),
                        ("All parameters in use", "parameters.prm")):
        files = [text for folder in folders if (text := text_of(folder, name))]
        check([text for other, text in parts if other == title] == files,
              f"{title}: {[len(text) for text in files]} characters")


def check_content(driver, runs):
    """The page says what is in the folders of its runs."""
    content = driver.execute_script(CONTENT)
    summaries = [json.loads(text_of(run, "summary.json")) for run in runs]
    check_verdicts(content["boxes"], summaries)
    check_segments(content["segments"], summaries)
    check_captions(content["captions"], len(runs), sum(
        os.path.isfile(os.path.join(run, "fields", "fluid.pvd"))
        for run in runs))
    check_provenance(content["setUp"], runs)


def check_page(driver, report, n_pictures, n_findings, folder):
    """All assertions on the look, at all widths."""
    for width in WIDTHS:
        set_width(driver, width)
        driver.get("file://" + os.path.abspath(report))
        severe = [entry["message"] for entry in driver.get_log("browser")
                  if entry["level"] == "SEVERE"]
        check(not severe, f"{width}: no errors {severe}")
        loaded = driver.execute_script(
            "return performance.getEntriesByType('resource')"
            ".map((entry) => entry.name).filter((n) => !n.startsWith('data:'))")
        check(not loaded, f"{width}: nothing is loaded from elsewhere {loaded}")
        images = driver.execute_script(PICTURES)
        check(len(images) == n_pictures and all(
            image[1] and image[2] > 0 for image in images),
            f"{width}: {len(images)} of {n_pictures} pictures are present")
        check_findings(driver, n_findings)
        check(all(image[0] for image in images),
              f"{width}: every picture has a text in its place")
        shares = driver.execute_script(CANVASES)
        check(shares and min(shares) > .05,
              f"{width}: the valve is drawn on each canvas {shares}")
        wide = driver.execute_script(TOO_WIDE)
        check(not wide, f"{width}: all text fits {wide[:5]}")
        if folder:
            take_screenshots(driver, os.path.join(folder, str(width)), width)


def arguments():
    """Reads the command line."""
    parser = argparse.ArgumentParser()
    parser.add_argument("report")
    parser.add_argument("--runs", nargs="+", required=True)
    parser.add_argument("--pictures", type=int, required=True)
    parser.add_argument("--findings", type=int, default=0)
    parser.add_argument("--shots")
    return parser.parse_args()


def main():
    """Checks the report that is named on the command line."""
    options = arguments()
    driver = browser()
    try:
        check_page(driver, options.report, options.pictures, options.findings,
                   options.shots)
        check_content(driver, options.runs)
        check_controls(driver)
    finally:
        driver.quit()
    return 1 if failures else 0


sys.exit(main())
