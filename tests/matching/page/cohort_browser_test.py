#!/usr/bin/python3
"""The page of a cohort as a browser shows it: no complaint, no network, and what is clicked or moved changes what is seen."""

import pathlib
import subprocess
import tempfile
import unittest

import page_case
from page_case import browser

pages = None  # the program that writes them (tests/apps/cohorts/report/cohort_pages.cpp)
results = None
ODD = "</script><b>09"


def setUpModule():
    global results
    results = tempfile.TemporaryDirectory()
    subprocess.run([pages, results.name], check=True)


def tearDownModule():
    results.cleanup()


def page(name):
    return pathlib.Path(results.name) / f"{name}.html"


def shapes(name):
    """Coordinates of the subjects in the statistics, by their ids."""
    rows = [line.rsplit(" ", line.count(" ")) for line in page(name).with_suffix(".txt").read_text().splitlines()]
    return {words[0]: [float(x) for x in words[1:]] for words in rows}


class CohortTest(page_case.PageCase):
    def open(self, name):
        super().open(page(name))

    def get(self, expression):
        return self.browser.run(f"const r = window.shellmatchReport; return {expression}")

    def rank(self, name):
        return self.get(f"r.model.subjects.find((s) => s.id === {name!r}).rank")

    def ids(self):
        return self.browser.run("return [...document.querySelectorAll('#subjects tbody th')].map((th) => th.firstChild.textContent)")

    def click(self, name):
        self.browser.run("document.getElementById(arguments[0]).click()", name)
        self.browser.settle()

    def shown_error(self, name, subject):
        """The greatest difference of a coordinate of the shape that is shown from the subject's own, or from coordinates."""
        dimension, shown = self.get("[r.model.dimension, Array.from(r.state.positions)]")
        coordinates = [x for i, x in enumerate(shown) if i % 3 < dimension]
        true = shapes(name)[subject] if isinstance(subject, str) else subject
        self.assertEqual(len(coordinates), len(true))
        return max(abs(x - y) for x, y in zip(coordinates, true))

    def test_shows_the_cohort_without_a_network(self):
        for name, chips in (("space", ["1 timed out", "1 not matched", "1 look here", "9 matched"]), ("plane", ["1 timed out", "1 not matched", "1 look here", "9 matched"]),
                            ("one", ["1 matched"]), ("none", ["1 crashed", "1 not run"]), ("large", ["1 timed out", "1 not matched", "1 look here", "37 matched"])):
            self.open(name)
            self.assertEqual(self.browser.run("return performance.getEntriesByType('resource').map(e => e.name).filter(n => !n.startsWith('data:'))"), [])
            self.assertEqual(self.browser.run("return [...document.querySelectorAll('header .outcome')].map(e => e.textContent)"), chips)
            self.assertEqual(len(self.ids()), self.get("r.model.data.subjects.length"))

    def test_a_subject_is_shown_by_its_scores(self):
        for name in ("space", "plane"):
            self.open(name)
            self.assertEqual(len(shapes(name)), 10)
            parts = ("pane-shape", "modes")
            before = [self.browser.picture(part) for part in parts]
            for subject in shapes(name):
                self.browser.set("shape", f"subject {self.rank(subject)}")
                after = [self.browser.picture(part) for part in parts]
                for i, part in enumerate(parts):
                    self.assertNotEqual(before[i], after[i], part)
                before = after
                # All modes are there, and coordinates of some 100 are rounded.
                self.assertLess(self.shown_error(name, subject), 0.02)
                self.assertIn(subject, self.browser.run("return document.getElementById('caption').textContent"))
            self.browser.set("shape", "group 1")
            members = [shapes(name)[s] for s in self.get("r.model.subjects.filter((s) => s.scores && s.group === 'b').map((s) => s.id)")]
            self.assertEqual(len(members), 5)
            self.assertLess(self.shown_error(name, [sum(x) / len(x) for x in zip(*members)]), 0.02)

    def test_sliders_move_the_shape_and_reset_brings_the_mean_back(self):
        for name in ("space", "plane"):
            self.open(name)
            first = self.browser.picture("pane-shape")
            self.browser.run("document.getElementById('scatter').scrollIntoView({ block: 'center' })")
            self.changes(lambda: self.browser.set("mode-1", 2.5), changed=["pane-shape", "modes", "scatter"])
            moved = self.get("[r.state.b[0], r.model.modes[0].reduce((e, x, i) => Math.max(e, Math.abs(r.state.positions[i] - r.model.mean[i] - 2.5 * x)), 0)]")
            self.assertEqual(moved[0], 2.5)
            self.assertLess(moved[1], 1e-4)
            self.changes(lambda: self.browser.set("mode-2", -2), changed=["pane-shape", "modes", "scatter"], same=["axis-x"])
            self.changes(lambda: self.browser.set("overlay", True), changed=["pane-shape"])
            self.browser.set("overlay", False)
            self.assertEqual(self.browser.run("return document.getElementById('shape').value"), "free")
            self.click("reset-modes")
            self.assertEqual(self.browser.picture("pane-shape"), first)
            self.assertEqual(self.browser.run("return document.getElementById('shape').value"), "mean")

    def test_a_mode_plays_until_it_is_stopped(self):
        from selenium.webdriver import ActionChains
        import time
        self.open("space")
        ActionChains(self.browser.driver).send_keys(" ").perform()
        seen = set()
        for _ in range(6):
            time.sleep(0.15)
            seen.add(self.get("r.state.b[0]"))
        self.assertGreater(len(seen), 3)
        self.assertLessEqual(max(map(abs, seen)), 3)
        ActionChains(self.browser.driver).send_keys(" ").perform()
        self.browser.settle()
        stopped = self.get("r.state.b")
        time.sleep(0.3)
        self.assertEqual(self.get("r.state.b"), stopped)
        self.assertEqual(set(stopped[1:]), {0})

    def test_colours_have_units_and_change_what_is_seen(self):
        keys = ["plain", "deviation", "displacement", "difference", "normal", "p"]
        for name in ("space", "plane"):
            self.open(name)
            self.assertEqual(self.browser.run("return [...document.querySelectorAll('#coloring option')].map(o => o.value)"), keys)
            self.browser.set("mode-1", 2)
            seen = set()
            for key in keys:
                self.browser.set("coloring", key)
                seen.add(self.browser.picture("pane-shape"))
                legend = self.browser.run("return document.getElementById('legend').textContent")
                if key not in ("plain", "p"):
                    self.assertIn("(mm)", legend, key)
            self.assertEqual(len(seen), len(keys))
            self.assertIn("0.05", legend)
            # Where p is below 0.05 colours are between yellow and red, elsewhere grey.
            chroma = self.get("""(() => { const p = r.model.arrays.p_corrected, c = r.view.colorings.p.colors();
                return [true, false].map((below) => Array.from(p, (x, i) => c[3 * i] - c[3 * i + 2]).filter((_, i) => p[i] < 0.05 === below)) })()""")
            self.assertGreater(min(chroma[0]), 90)
            self.assertLess(max(map(abs, chroma[1])), 20)
            # Points that are where the mean has them have the first colour; 2 SD of mode 1 are two thirds of the scale, which mode 1 sets.
            reds = self.get("[r.model.mean, r.state.positions].map((x) => [...new Set(Array.from(r.view.colorings.displacement.colors(x)).filter((_, i) => i % 3 === 1))].sort((a, b) => b - a))")
            self.assertEqual(reds[0], [1])
            self.assertTrue(120 < reds[1][0] < 206, reds[1][0])

    def test_a_click_on_a_point_shows_that_subject_and_the_pointer_names_it(self):
        from selenium.webdriver import ActionChains
        from selenium.webdriver.common.by import By
        for name in ("space", "plane"):
            self.open(name)
            canvas = self.browser.driver.find_element(By.ID, "scatter")
            self.browser.run("arguments[0].scrollIntoView({ block: 'center' })", canvas)
            for subject in ("subject-02", "subject-10"):
                rank = self.rank(subject)
                x, y = self.get(f"r.scatter.pixelOf({rank})")
                size = canvas.size
                there = (round(x - size["width"] / 2), round(y - size["height"] / 2))
                self.changes(lambda: ActionChains(self.browser.driver).move_to_element_with_offset(canvas, *there).perform(), changed=["scatter"], same=["pane-shape"])
                self.assertIn(subject, self.get("r.scatter.hovered()")[0])
                self.changes(lambda: ActionChains(self.browser.driver).move_to_element_with_offset(canvas, *there).click().perform(), changed=["pane-shape", "modes"])
                self.assertEqual(self.get("r.state.subject"), rank)
                self.assertLess(self.shown_error(name, subject), 0.02)
                self.assertEqual(self.browser.run("return document.querySelector('#subjects tr.shown th').firstChild.textContent"), subject)
            self.changes(lambda: self.browser.set("axis-y", "2"), changed=["scatter"], same=["pane-shape"])
            self.assertEqual(self.get("r.state.subject"), rank)

    def test_the_table_is_sorted_and_filtered(self):
        self.open("space")
        worst_first = self.ids()
        self.assertEqual(worst_first[:3], ["subject-03", "subject-07", "subject-05"])
        self.assertEqual(worst_first, self.get("r.model.data.subjects.map((s) => s.id)"))
        self.click("sort-id")
        by_id = self.ids()
        self.assertEqual([name for name in by_id if name != ODD], sorted(name for name in by_id if name != ODD))
        self.click("sort-id")
        self.assertEqual(self.ids(), by_id[::-1])
        for key, way in (("there", "atlas_to_subject"), ("back", "subject_to_atlas")):
            self.click(f"sort-{key}")
            distance = dict(self.get(f"r.model.data.subjects.map((s) => [s.id, s.distance ? s.distance.{way}.max : -1])"))
            order = [distance[name] for name in self.ids()]
            self.assertEqual(order, sorted(order, reverse=True))
            self.assertEqual(self.browser.run(f"return document.getElementById('sort-{key}').closest('th').getAttribute('aria-sort')"), "ascending")
        self.click("sort-verdict")
        self.assertEqual(self.ids(), worst_first)
        self.browser.set("filter", "not reached")
        self.assertEqual(self.ids(), ["subject-07", "subject-05"])
        self.browser.set("filter", "nobody")
        self.assertEqual(self.ids(), [])

    def test_rows_show_pictures_and_distances_and_link_to_reports(self):
        self.open("space")
        self.assertEqual(self.browser.run("return [...document.querySelectorAll('#subjects img')].filter((i) => i.naturalWidth > 100).length"), 10)
        cells = self.browser.run("return [...document.querySelectorAll('#subjects tbody tr')].map((tr) => [...tr.cells].map((td) => td.textContent))")
        self.assertEqual(cells[1][2:5], ["a", "22.321 %", "27.626 %"])  # of a diagonal of 106
        self.assertIn("timed out", cells[0][5])
        self.assertIn("stopped after 600 s", cells[0][5])
        links = dict(self.browser.run("return [...document.querySelectorAll('#subjects a')].map((a) => [a.closest('th').firstChild.textContent, a.getAttribute('href')])"))
        self.assertEqual(links["subject-02"], "./runs/subject-02/output/report.html")
        self.assertEqual(links[ODD], "./runs/a%20b%23%3F/output/report.html")
        self.assertNotIn("subject-03", links)
        self.assertEqual(self.browser.run("return document.querySelectorAll('b').length"), 0)
        self.changes(lambda: self.browser.run("document.querySelector('#subjects tbody tr:nth-child(4) button').click()"), changed=["pane-shape"])
        self.assertEqual(self.get("r.state.subject"), 3)

    def test_without_a_model_a_shape_and_the_table_remain(self):
        for name, caption in (("one", "The atlas on subject-01"), ("none", "The atlas: no subject")):
            self.open(name)
            self.assertTrue(self.browser.run("return document.getElementById('caption').textContent").startswith(caption))
            self.assertEqual(self.browser.run("return document.querySelectorAll('#modes input, #shape, #scatter').length"), 0)
            self.assertIn("two subjects at least", self.browser.run("return document.getElementById('panels').textContent"))
            blank = self.browser.run("return getComputedStyle(document.body).backgroundColor")
            self.assertTrue(blank)
            before = self.browser.picture("pane-shape")
            self.browser.run("r = window.shellmatchReport.view.camera.zoom(0.7)")
            self.browser.settle()
            self.assertNotEqual(self.browser.picture("pane-shape"), before)

    def test_keys_turn_colour_and_darken(self):
        from selenium.webdriver import ActionChains
        from selenium.webdriver.common.keys import Keys
        self.open("space")
        first = self.browser.picture("pane-shape")
        self.changes(lambda: ActionChains(self.browser.driver).send_keys("c").perform(), changed=["pane-shape", "legend"])
        self.browser.set("coloring", "deviation")
        self.browser.run("document.getElementById('views').focus()")
        for key in (Keys.ARROW_LEFT, "+"):
            self.changes(lambda: ActionChains(self.browser.driver).send_keys(key).perform(), changed=["pane-shape"])
        self.click("reset")
        self.assertEqual(self.browser.picture("pane-shape"), first)
        back = "return getComputedStyle(document.body).backgroundColor"
        light = self.browser.run(back)
        self.changes(lambda: ActionChains(self.browser.driver).send_keys("d").perform(), changed=["pane-shape", "panels"])
        self.assertNotEqual(self.browser.run(back), light)

    def test_the_definitions_say_what_is_shown(self):
        self.open("large")
        words = self.browser.run("return document.querySelector('dl').textContent")
        self.assertIn("on the 12 modes that this page holds", words)
        self.assertNotIn("Hotelling", words)
        self.open("space")
        words = self.browser.run("return document.getElementById('panels').textContent")
        for word in ("Hotelling", "Davies", "Gower", "Westfall", "generalisation", "specificity", "compactness"):
            self.assertIn(word, words)
        self.assertIn("0.08 %", words)  # the last round's change


class WithoutWebGL(unittest.TestCase):
    def test_pictures_and_figures_remain(self):
        with browser.Browser(webgl=False) as other:
            self.assertEqual(other.open(page("space"))[0], "true")
            self.assertIn("no WebGL", other.run("return document.getElementById('views').textContent"))
            self.assertEqual(other.run("return document.querySelectorAll('#subjects img').length"), 10)
            self.assertEqual(other.errors(), [])


if __name__ == "__main__":
    pages, words = page_case.begin(__doc__, "--pages")
    unittest.main(argv=words)
