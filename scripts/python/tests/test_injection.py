# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Markup and words for a shell in every name: nothing of them is executed, in the shell or in a browser that clicks all there is to click.

Needs Debian's chromium, and ffmpeg for the film.
"""

import html
import html.parser
import os
import pathlib
import re
import shutil
import subprocess
import unittest
import urllib.parse
import xml.etree.ElementTree

import voussoir
from fixture import ROOT, InAFolder

MARKUP = ["<img src=x onerror=executed()>", "</script><script>executed()</script>", '"><svg onload=executed()>', "'-executed()-'", "${executed()}",
          "<iframe src=javascript:parent.executed()>", "<b onmouseover=executed() onclick=executed()>b</b>", "--><script>executed()</script>"]
SHELL = ["$(touch executed)", "`touch executed`", "; touch executed;", "| touch executed", "' ; touch executed ; '", "-o executed", "%s%n"]
CHROMIUM = next((p for p in ("chromium", "chromium-browser", "google-chrome") if shutil.which(p)), None)

# Runs in the page once it is there: clicks, chooses and points at everything, then says what came of it.
CLICKS = """<script>
window.runs = 0;
window.executed = () => { window.runs += 1; };
window.addEventListener("load", () => setTimeout(async () => {
  try { await window.opened; } catch (e) { document.documentElement.dataset.fault = e; }
  let clicks = 0;
  for (const element of document.querySelectorAll("body *")) {
    if (element.tagName === "A" && element.href) element.removeAttribute("download");
    for (const kind of ["pointerover", "mouseover", "pointermove", "mousemove", "pointerdown", "mousedown", "pointerup", "mouseup", "click", "dblclick"])
      element.dispatchEvent(new MouseEvent(kind, {bubbles: true, cancelable: true, clientX: 400, clientY: 300}));
    if (element.tagName === "SELECT") for (const option of element.options) {
      element.value = option.value;
      element.dispatchEvent(new Event("input", {bubbles: true}));
      element.dispatchEvent(new Event("change", {bubbles: true}));
    }
    clicks += 1;
  }
  await new Promise((done) => setTimeout(done, 500));
  document.documentElement.dataset.seen = `clicks ${clicks}, executed ${window.runs}`;
}, 200));
</script>"""


class Elements(html.parser.HTMLParser):
    """Names of elements with attributes that run something or fetch something, as the browser has them."""

    def __init__(self, text):
        super().__init__()
        self.odd = []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name.startswith("on") or (value or "").startswith("javascript:"):
                self.odd.append((tag, name, value))
        if tag in ("iframe", "object", "embed", "img"):
            self.odd += in_picture(dict(attributes).get("src") or "", tag)


def in_picture(source, tag):
    """What a picture would run or fetch: nothing, if it is one of the page's own maps and holds no such elements itself."""
    kind, _, drawing = source.partition(",")
    if tag != "img" or not kind.startswith("data:image/svg+xml"):
        return [(tag, source, None)]
    drawing = urllib.parse.unquote(drawing)
    return Elements(drawing).odd + [("script", drawing, None)] * drawing.lower().count("<script")


class Injection(InAFolder):
    def setUp(self):
        super().setUp()
        self.before = pathlib.Path.cwd()
        os.chdir(self.folder)  # where a shell would touch its file
        self.addCleanup(os.chdir, self.before)

    def model(self):
        """A wall and a house's worth of names: title, materials, laws, blocks, parts, ties, followed points."""
        words = iter((MARKUP + SHELL) * 4)
        model = voussoir.Model(" ".join(MARKUP + SHELL))
        model["gravity.settle"], model["time.duration"] = False, 0.05
        model["output.frame_interval"] = 0.01
        stone, law = f"stone {next(words)}", f"law {next(words)}"
        model.material(stone, density=2000.0, young=1e8, poisson=0.2)
        model.joint_law(law, tension=1.0, cohesion=1.0, friction=30.0, compression=1e6)  # weak, so that there are cracks
        model["joints.default"] = law
        model["base.z"] = 0.0
        names = []
        for k in range(len(MARKUP + SHELL)):
            x = 0.2 * (k % 5)
            z = 0.2 * (k // 5)
            names.append(f"{k} {next(words)}")
            model.box(names[-1], [x, 0, z], [x + 0.2, 0.2, z + 0.2], material=stone, part=f"{next(words).replace(',', ' ')} wall")
        points = [word.replace("/", "|") for word in MARKUP + SHELL]
        for k, point in enumerate(points):
            model.follow(point, [0.2 * (k % 5) + 0.1, 0.1, 0.2 * (k // 5) + 0.1])
        model.case["tie"] = [{"name": MARKUP[0], "from": [0.0, 0.1, 0.3], "to": [1.0, 0.1, 0.3], "area": 1e-4, "young": 2e11, "yield": 2e8}]
        model.motion("bam-like")
        return model

    def house(self):
        """A small house with names of its own: materials, joint laws, inner walls, rods, meshes, cuts, points; stones from a file."""
        words = iter((MARKUP + SHELL) * 4)
        stones = self.folder / f"{SHELL[0]}.obj"
        text = []
        for k, name in enumerate(MARKUP):
            text.append(f"o {name}")
            text += [f"v {x + 0.3 * k} {y} {z}" for z in (0.0, 0.2) for x, y in ((0.0, -1.0), (0.2, -1.0), (0.2, -0.8), (0.0, -0.8))]
            text += ["f " + " ".join(str(8 * k + i) for i in face)
                     for face in ((1, 4, 3, 2), (5, 6, 7, 8), (1, 2, 6, 5), (2, 3, 7, 6), (3, 4, 8, 7), (4, 1, 5, 8))]
        stones.write_text("\n".join(text) + "\n")
        model = voussoir.Model(MARKUP[1], include=ROOT / "tests/io/samples/house.toml")
        model["time.duration"], model["output.frame_interval"] = 0.1, 0.05
        brick, weak, wood = f"brick {next(words)}", f"weak {next(words)}", f"wood {next(words)}"
        model.material(brick, density=1800.0, young=9.8e7, poisson=0.25)
        model.material(wood, density=700.0, young=6.3e8, poisson=0.3)
        model.joint_law(weak, tension=460.0, cohesion=290.0, friction=32.0, compression=4.9e5)
        model.joint_law(wood, tension=1e7, cohesion=9e6, friction=0.0, compression=4.5e7)
        model.house(material=brick, joint=weak, inner_size=[1.0, 0.2], wood={"material": wood, "within_member": wood, "between_members": weak},
                    inner_wall=[{"name": next(words), "at": 0.5, "thickness": 0.1}])
        rod = {"kind": "across", "walls": ["front"], "heights": [0.3], "at": [0.3], "area": 1e-5}
        model.case["house"]["tie"] = [{"name": word, **rod, "heights": [0.02 * k + 0.1]} for k, word in enumerate(MARKUP)]
        model.case["house"]["mesh"] = [{"name": next(words), "walls": ["front"], "stiffness": 1e5}]
        model.case["output"]["cut"] = [{"name": word.replace("/", "|"), "point": [0.5, 0.2, 0.02 * k + 0.1]} for k, word in enumerate(MARKUP + SHELL)]
        model.add_stones(stones, unit="m", name=next(words), material=brick)
        for k, word in enumerate(MARKUP + SHELL):
            model.follow(word.replace("/", "|"), [0.06 * k, 0.05, 0.35])
        return model

    def shown(self, page):
        """The page as a browser has it after clicks on everything; the console's faults do not matter here."""
        copy = self.folder / "clicked.html"
        text = page.read_text(encoding="utf-8")
        self.assertIn("<head>", text)
        copy.write_text(text.replace("<head>", "<head>" + CLICKS, 1), encoding="utf-8")
        words = [CHROMIUM, "--headless", "--no-sandbox", "--disable-gpu", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
                 f"--user-data-dir={self.folder}/profile", "--virtual-time-budget=20000", "--dump-dom", copy.as_uri()]
        return subprocess.run(words, capture_output=True, text=True, timeout=300, check=False).stdout

    def nothing_ran(self, page):
        dom = self.shown(page)
        seen = re.search(r'data-seen="clicks (\d+), executed (\d+)"', dom)
        self.assertIsNotNone(seen, dom[:2000])
        self.assertGreater(int(seen[1]), 50)
        self.assertEqual(int(seen[2]), 0)
        self.assertEqual(Elements(dom).odd, [])
        return dom

    def assert_no_shell(self):
        self.assertEqual([str(p) for p in self.folder.rglob("executed*")], [])

    @unittest.skipIf(CHROMIUM is None, "no chromium")
    def test_the_clicks_find_what_is_executed(self):
        page = self.folder / "page.html"
        page.write_text(f"<html><head></head><body>{'<p>p</p>' * 60}<p>{MARKUP[0]}</p></body></html>")
        with self.assertRaises(AssertionError):
            self.nothing_ran(page)

    @unittest.skipIf(CHROMIUM is None, "no chromium")
    def test_pages(self):
        model = self.model()
        folder = self.folder / "$(touch executed) <img src=x onerror=executed()>"
        run = model.run(folder, threads=1, progress=False)
        other = model.run(self.folder / "other", until=0.03, threads=1, progress=False)
        for page in (run.report(), run.report(other=other), model.view(self.folder / "view.html")):
            self.nothing_ran(page)
        self.assert_no_shell()

    @unittest.skipIf(CHROMIUM is None, "no chromium")
    def test_pages_of_a_house(self):
        model = self.house()
        run = model.run(self.folder / "run", threads=1, progress=False)
        shown = html.unescape(self.nothing_ran(run.report()))
        self.nothing_ran(model.view(self.folder / "view.html"))
        self.assert_no_shell()
        house = model.case["house"]
        for name in (MARKUP[1], house["inner_wall"][0]["name"], house["tie"][0]["name"], model.case["output"]["cut"][0]["name"]):
            self.assertIn(name, shown)

    def test_drawings_and_files(self):
        self.drawings_and_files(self.model())

    def test_drawings_and_files_of_a_house(self):
        self.drawings_and_files(self.house())

    def drawings_and_files(self, model):
        run = model.run(self.folder / "run", threads=1, progress=False)
        model.check(draw=self.folder / "`touch executed`.svg")
        voussoir.call("assess", run.folder, "--maps", self.folder / "maps ; touch executed", "--spectra", self.folder / "| touch executed.csv")
        drawings = list(self.folder.rglob("*.svg"))
        self.assertGreater(len(drawings), 1)
        for drawing in drawings:
            self.assertTrue(drawing.resolve().is_relative_to(self.folder.resolve()))
            for element in xml.etree.ElementTree.parse(drawing).iter():
                self.assertNotIn(element.tag.rsplit("}", 1)[-1], ("script", "foreignObject", "image", "a", "img", "iframe"))
                self.assertEqual([name for name in element.attrib if name.lower().startswith("on")], [])
        voussoir.call("report", run.folder, "--paraview")
        xml.etree.ElementTree.parse(run.folder / "run.xdmf")
        for words in (("summary", run.folder), ("check", self.folder / "run"), ("compare", run.folder, run.folder)):
            voussoir.call(*words)
        self.assertEqual([p for p in self.folder.rglob("executed*") if p.name == "executed"], [])

    @unittest.skipIf(CHROMIUM is None or not shutil.which("ffmpeg"), "no chromium or no ffmpeg")
    def test_films_and_pictures(self):
        run = self.model().run(self.folder / "run", threads=1, progress=False)
        for name in ("$(touch executed);`touch executed`.gif", "-y executed %d%s.gif"):
            film = run.film(self.folder / name, speed=0.5)
            self.assertTrue(film.read_bytes().startswith(b"GIF89a"), name)
            self.assertEqual(film.parent, self.folder)
        voussoir.call("report", run.folder, "--stills", "0.02", "-o", self.folder / "stills $(touch executed)")
        self.assertEqual([p for p in self.folder.rglob("*") if p.name == "executed"], [])

    def test_studies(self):
        def build(stone, scale):
            model = voussoir.Model(stone)
            model["gravity.settle"], model["time.duration"], model["motion.scale"] = False, 0.01, scale
            model.material(stone, density=2000.0, young=1e8, poisson=0.2)
            model["base.z"] = 0.0
            model.box(stone, [0, 0, 0], [0.2, 0.2, 0.2], material=stone)
            model.motion("bam-like")
            return model
        study = voussoir.Study(self.folder / "study $(touch executed) <b>", build, stone=[MARKUP[0], MARKUP[2], SHELL[0], "../../outside"], scale=[1.0])
        study.run(quiet=True)
        self.assertEqual({row["status"] for row in study.table()}, {"done"})
        study.write(self.folder / "; touch executed.csv")
        self.assertEqual({p.parent for p in self.folder.rglob("run.h5")}, {study.folder / name for name in study.runs})
        self.assertEqual([p for p in self.folder.rglob("*") if p.name == "executed"], [])
