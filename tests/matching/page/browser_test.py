#!/usr/bin/python3
"""report.html as a browser shows it: no complaint, no network, and what is clicked or moved changes what is seen."""

import base64
import csv
import json
import pathlib
import struct
import subprocess
import tempfile
import time
import unittest

import page_case
from page_case import browser

# Long edges: the browser draws surfaces without a graphics card.
SURFACES = {"hand": "hand", "bent": "hand/bent", "ball": "sphere"}
RUNS = {
    "hand": ["hand.ply", "bent.ply", "--levels", "3:4", "--placement", "as-is", "--set", "pictures=result"],
    "leaf": ["generate:leaf/deep", "generate:leaf/shallow", "--levels", "4:6"],
    # A ball that was not told where the limbs are.
    "unlike": ["ball.ply", "hand.ply", "--levels", "3:4", "--set", "input.unit=mm"],
}
program = None
results = None


def setUpModule():
    global results
    results = tempfile.TemporaryDirectory()

    def call(*words):
        subprocess.run([program, *words], check=True, cwd=results.name, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL)

    for name, shape in SURFACES.items():
        call("generate", shape, "-o", f"{name}.ply", "--edge-length", "0.025")
    for name, words in RUNS.items():
        call("match", "--set", "pictures=none", *words, "--align", "none", "-o", name, "-q")


def tearDownModule():
    results.cleanup()


def folder(name):
    return pathlib.Path(results.name) / name


def column(stem, name):
    """Values at the vertices in stem.csv, or in stem.ply (binary, little endian)."""
    if (table := stem.with_suffix(".csv")).exists():
        with table.open() as lines:
            return [float(row[name]) for row in csv.DictReader(lines)]
    head, _, body = stem.with_suffix(".ply").read_bytes().partition(b"end_header\n")
    words = [line.split() for line in head.decode().splitlines()]
    count, first = next((int(w[2]), i + 1) for i, w in enumerate(words) if w[:2] == ["element", "vertex"])
    properties = []
    for w in words[first:]:
        if w[0] != "property":
            break
        properties.append(w[1:])
    form = "<" + "".join({"double": "d", "float": "f", "int": "i", "uchar": "B"}[kind] for kind, _ in properties)
    at = [n for _, n in properties].index(name)
    return [record[at] for record in struct.iter_unpack(form, body[:count * struct.calcsize(form)])]


class ReportTest(page_case.PageCase):
    def open(self, name):
        super().open(folder(name) / "report.html")
        self.summary = json.loads((folder(name) / "summary.json").read_text())

    def check_numbers(self, name):
        largest = "return arguments[0].map(n => window.shellmatchReport.model.arrays[n].reduce((m, x) => Math.max(m, x), 0))"
        shown = self.browser.run(largest, ["distance_to_template", "distance_to_deformed"])
        diagonal, distance = self.summary["template_diagonal"], self.summary["distance"]
        # The summary looks between the vertices, too, where facets bend.
        for k, (stem, attribute, way) in enumerate([("deformed", "distance_to_template", "deformed_to_template"), ("template", "distance_to_deformed", "template_to_deformed")]):
            self.assertAlmostEqual(shown[k] / max(column(folder(name) / stem, attribute)), 1, delta=2e-4)
            self.assertLess(shown[k] / (distance[way]["max"] * diagonal), 1.1)
        counts = self.browser.run("const m = window.shellmatchReport.model; return [m.reference, m.template].map(s => [s.positions.length / 3, s.facets.length / m.dimension])")
        self.assertEqual(counts, [[self.summary[s]["vertices"], self.summary[s]["facets"]] for s in ("reference", "template")])

    def check_grid(self):
        grid = self.browser.run("""const m = window.shellmatchReport.model, g = m.grid(), n = g.cornersPerCell; let volume = 0;
            for (let c = 0; c < g.levels.length; ++c) volume += Math.pow(2, -m.dimension * g.levels[c]);
            const box = p => p.reduce(([a, b], x) => [Math.min(a, x), Math.max(b, x)], [Infinity, -Infinity]);
            return { cells: g.levels.length, volume, box: box(g.positions), most: box(g.from.map((x, i) => Math.abs(x - g.to[i])))[1] / m.data.grid.side }""")
        self.assertEqual(grid["cells"], self.summary["levels"][-1]["cells"])
        self.assertAlmostEqual(grid["volume"], 1, delta=1e-9)
        self.assertEqual(grid["box"], [0, 1])
        self.assertTrue(0.01 < grid["most"] < 0.7, grid["most"])

    def test_shows_the_run_without_a_network(self):
        for name in RUNS:
            self.open(name)
            self.assertEqual(self.browser.run("return performance.getEntriesByType('resource').map(e => e.name).filter(n => !n.startsWith('data:'))"), [])
            self.assertEqual(self.browser.run("return window.shellmatchReport.model.levels.map(l => l.level)"), [level["level"] for level in self.summary["levels"]])
            self.check_numbers(name)
            self.check_grid()

    def test_sliders_colours_and_grid_change_what_is_seen(self):
        for name in ("hand", "leaf"):
            self.open(name)
            left = ("pane-reference", "pane-template")
            panes = "return ['reference', 'template', 'result'].map(n => document.getElementById('pane-' + n).getBoundingClientRect().height)"
            heights = self.browser.run(panes)
            self.changes(lambda: self.browser.set("time", 0.4), changed=["pane-result"], same=left)
            self.browser.set("time", 1)
            self.changes(lambda: self.browser.set("level", 0), changed=["pane-result"], same=left)
            self.changes(lambda: self.browser.set("coloring", "distance"), changed=["pane-result", *left, "legend"])
            keys = self.browser.run("return Array.from(document.querySelectorAll('#coloring option')).map(o => o.value)")
            self.assertEqual("angle" in keys, name == "hand")
            seen = set()
            for key in keys:
                self.browser.set("coloring", key)
                seen.add(self.browser.picture("pane-result"))
            self.assertEqual(len(seen), len(keys))
            self.changes(lambda: self.browser.set("grid", "0"), changed=["pane-result", "pane-reference"], same=["pane-template"])
            shown = self.browser.run("return document.getElementById('overlay').checked")
            self.changes(lambda: self.browser.set("overlay", not shown), changed=["pane-result"], same=left)
            self.assertEqual(self.browser.run(panes), heights)

    def test_the_time_slider_stops_the_animation(self):
        self.open("leaf")
        self.browser.run("document.getElementById('play').click()")
        self.browser.settle()
        self.assertLess(self.browser.run("return window.shellmatchReport.state.t"), 1)
        self.browser.set("time", 0.3)
        time.sleep(0.3)  # frames that would go on
        shown = self.browser.run("return [window.shellmatchReport.state.t, document.getElementById('play').getAttribute('aria-label')]")
        self.assertEqual(shown, [0.3, "Play"])

    def test_angles_are_turns_of_directions(self):
        self.open("hand")
        self.browser.set("coloring", "angle")
        for part, text in (("legend", "largest turn of a direction (degrees)"), ("panels", "largest turn of a direction, 90 % of the surface")):
            self.assertIn(text, self.browser.run("return document.getElementById(arguments[0]).textContent", part))

    def test_a_slice_moves_and_cuts(self):
        self.open("hand")
        self.browser.set("grid", "2")
        both = ["pane-result", "pane-reference"]
        self.changes(lambda: self.browser.set("place", 0.45), changed=both, same=["pane-template"])
        self.changes(lambda: self.browser.set("cut", True), changed=both, same=["pane-template"])

    def test_one_camera_for_all_views(self):
        from selenium.webdriver import ActionChains
        from selenium.webdriver.common.by import By
        from selenium.webdriver.common.keys import Keys
        panes = ["pane-reference", "pane-template", "pane-result"]
        for name in ("hand", "leaf"):
            self.open(name)
            first = self.browser.picture("pane-result")
            template = self.browser.driver.find_element(By.ID, "pane-template")
            drag = ActionChains(self.browser.driver, duration=50).move_to_element(template).click_and_hold().move_by_offset(40, 25).release()
            self.changes(drag.perform, changed=panes)
            self.changes(lambda: ActionChains(self.browser.driver).send_keys(Keys.ARROW_LEFT).perform(), changed=panes)
            self.changes(lambda: ActionChains(self.browser.driver).send_keys("+").perform(), changed=panes)
            self.browser.run("document.getElementById('reset').click()")
            self.browser.settle()
            self.assertEqual(self.browser.picture("pane-result"), first)

    def test_keys_choose_colours_and_scheme(self):
        from selenium.webdriver import ActionChains
        self.open("hand")
        back = "return getComputedStyle(document.body).backgroundColor"
        light = self.browser.run(back)
        self.changes(lambda: ActionChains(self.browser.driver).send_keys("c").perform(), changed=["pane-result", "legend"])
        self.changes(lambda: ActionChains(self.browser.driver).send_keys("d").perform(), changed=["pane-result", "panels"])
        self.assertNotEqual(self.browser.run(back), light)
        self.changes(lambda: ActionChains(self.browser.driver).send_keys("C").perform(), changed=["pane-result", "legend"])
        self.changes(lambda: ActionChains(self.browser.driver).send_keys("D").perform(), changed=["pane-result", "panels"])
        self.assertEqual(self.browser.run(back), light)

    def test_a_place_of_the_verdict_is_flown_to_and_labels_have_units(self):
        self.open("unlike")
        self.assertEqual(self.summary["verdict"]["outcome"], "not-matched")
        self.assertEqual(self.browser.run("return document.getElementById('outcome').textContent"), "not matched")
        places = [reason["place"] for reason in self.summary["verdict"]["reasons"] if reason["place"]]
        self.assertEqual(self.browser.run("return document.querySelectorAll('.place').length"), len(places))
        camera = "const c = window.shellmatchReport.view.camera; return [c.controls.target.toArray(), c.position.toArray()]"
        before = self.browser.run(camera)
        self.changes(lambda: self.browser.run("document.querySelector('.place').click()"), changed=["pane-result", "pane-template"])
        target, eye = self.browser.run(camera)
        for x, place in zip(target, places[0]):
            self.assertAlmostEqual(x, place, delta=1e-6)
        self.assertNotEqual(eye, before[1])
        for key, label in (("distance", "(mm)"), ("curvature", "(1 / mm)")):
            self.browser.set("coloring", key)
            self.assertIn(label, self.browser.run("return document.getElementById('legend').textContent"))
        # The mark is where the place is seen: in the middle of the view.
        offset = self.browser.run("""const p = document.getElementById("pane-result"), m = p.querySelector(".mark").getBoundingClientRect(), b = p.getBoundingClientRect();
            return [(m.left + m.right - b.left - b.right) / 2, (m.top + m.bottom - b.top - b.bottom) / 2]""")
        self.assertLess(max(map(abs, offset)), 3)

    def test_damaged_data_are_said_to_be(self):
        page = (folder("leaf") / "report.html").read_text()
        begin = page.index('id="arrays">') + 12
        damaged = folder("leaf").parent / "damaged.html"
        damaged.write_text(page[:begin + 400] + page[page.index("</script>", begin):])
        self.assertEqual(self.browser.open(damaged)[0], "failed")
        self.assertIn("cannot be shown", self.browser.run("return document.body.textContent"))
        self.assertTrue(self.browser.errors())

    def test_seconds_are_rounded_before_they_become_minutes(self):
        source = (pathlib.Path(__file__).resolve().parents[3] / "matching/page/data/format.js").read_bytes()
        self.browser.driver.get("about:blank")
        texts = self.browser.driver.execute_async_script(
            "const [url, values, done] = arguments; import(url).then((m) => done(values.map(m.seconds)));",
            "data:text/javascript;base64," + base64.b64encode(source).decode(), [1.234, 119.4, 119.996, 179.7, 180.4])
        self.assertEqual(texts, ["1.23 s", "119 s", "2 min 0 s", "3 min 0 s", "3 min 0 s"])


class WithoutWebGL(unittest.TestCase):
    def test_a_picture_and_the_figures_remain(self):
        with browser.Browser(webgl=False) as other:
            self.assertEqual(other.open(folder("hand") / "report.html")[0], "true")
            self.assertIn("no WebGL", other.run("return document.getElementById('views').textContent"))
            self.assertGreater(other.run("return document.querySelector('#views img').naturalWidth"), 300)
            self.assertEqual(other.errors(), [])
            self.assertIn("result → template", other.run("return document.getElementById('panels').textContent"))


if __name__ == "__main__":
    program, words = page_case.begin(__doc__, "--program")
    program = pathlib.Path(program).resolve()
    unittest.main(argv=words)
