"""Opens a report in headless Chromium and asserts that it is whole: no errors,
no network, every picture present, every 3D canvas drawn, text that fits.

check_page.py REPORT --pictures NUMBER [--findings NUMBER] [--shots FOLDER]
counts pictures and findings; writes screenshots into the folder, if given.
"""

import argparse
import base64
import os
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


def take_screenshot(driver, file, width):
    """The whole page as a picture."""
    height = driver.execute_script("return document.body.scrollHeight")
    set_width(driver, width, height)
    driver.implicitly_wait(1)
    shot = driver.execute_cdp_cmd("Page.captureScreenshot", {"format": "png"})
    with open(file, "wb") as stream:
        stream.write(base64.b64decode(shot["data"]))


def check_findings(driver, number):
    """There are so many findings, each with a word."""
    words = driver.execute_script(FINDINGS)
    check(len(words) == number and
          all(word in ("pass", "fail", "not run") for word in words),
          f"{len(words)} findings {words}")


def check_page(driver, report, n_pictures, n_findings, folder):
    """All assertions, at all widths."""
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
            take_screenshot(driver, os.path.join(folder, f"{width}.png"), width)
    check_controls(driver)


def arguments():
    """Reads the command line."""
    parser = argparse.ArgumentParser()
    parser.add_argument("report")
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
    finally:
        driver.quit()
    return 1 if failures else 0


sys.exit(main())
