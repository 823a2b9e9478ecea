# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""How models, runs and capacities show themselves in Jupyter: some figures, and the page of the program in the output of the cell.

The page is packed into the output and unpacked by the browser, where scripts run and WebGL is there; elsewhere a picture stays.
"""

import base64
import contextlib
import gzip
import html
import json
import pathlib
import secrets
import tempfile
import warnings
from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Any

from . import commands
from .errors import VoussoirError

if TYPE_CHECKING:
    from .capacity import Capacity
    from .model import Model
    from .results import Results
    from .runs import Run

MOST = 1_500_000  # bytes of a packed page that is put into an output without being asked for
_STYLE = "max-width:960px;border:1px solid rgba(128,128,128,.4);border-radius:4px;padding:8px 12px;margin:4px 0"
# The page keeps its state in its address, which a frame within an output does not have.
_SCRIPT = """(() => {
const box = document.getElementById("NAME");
const gl = document.createElement("canvas").getContext("webgl2");
if (!box || !gl || typeof DecompressionStream === "undefined") return;
gl.getExtension("WEBGL_lose_context")?.loseContext();
new IntersectionObserver(async (seen, observer) => {
if (!seen.some((s) => s.isIntersecting)) return;
observer.disconnect();
const packed = Uint8Array.from(atob(box.dataset.page), (c) => c.charCodeAt(0));
const page = await new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"))).text();
const frame = document.createElement("iframe");
frame.setAttribute("sandbox", "allow-scripts allow-downloads");
frame.title = "TITLE"; frame.srcdoc = page.replace("<head>", "<head><script>history.replaceState = () => {};<\\/script>");
frame.style = "width:100%;height:HEIGHTpx;border:0";
box.replaceChildren(frame);
}).observe(box);
})();"""


class Shown:
    """HTML that a notebook shows."""

    def __init__(self, text: str) -> None:
        self.text = text

    def _repr_html_(self) -> str:
        return self.text


def html_of_model(model: "Model", *, most: int | None = MOST, height: int = 520) -> str:
    """What is in a model, with its page to turn; of a model that is refused what the program says. most: bytes of the packed page, None: any."""
    title = model.case.get("title", "") or "A model without a title"
    with tempfile.TemporaryDirectory(prefix="voussoir-") as scratch, _quiet():
        page = pathlib.Path(scratch) / "model.html"
        try:
            model.view(page)
            checked = _checked(model)
        except VoussoirError as error:
            return _box(_head(title) + f'<pre style="color:#c1272d;white-space:pre-wrap">{html.escape(str(error))}</pre>')
        return _box(_head(title) + _figures(figures_of_model(checked)) + _list(checked["findings"]) + _page(page.read_bytes(), _png_of_model(model), title, most, height))


def html_of_run(run: "Run", *, most: int | None = MOST, height: int = 520) -> str:
    """State and figures of a run, with its replay. most: as for html_of_model."""
    from .results import Results
    results = Results(run.folder)  # another reader: tables of `run` that somebody holds stay open
    with tempfile.TemporaryDirectory(prefix="voussoir-") as scratch, _quiet(), contextlib.closing(results):
        try:
            title, figures = title_of(results), figures_of_run(results)
            page = run.report(output=pathlib.Path(scratch) / "run.html").read_bytes() if len(results.frames) else b""
        except VoussoirError as error:
            return _box(_head(str(run.folder)) + f"<p>{html.escape(str(error))}</p>")
        return _box(_head(title, str(run.folder)) + _figures(figures) + _page(page, _png_of(results), title, most, height, _caption(results)))


def html_of_capacity(capacity: "Capacity") -> str:
    """The curve of a quasi-static analysis, and its main figures."""
    if not capacity:
        return _box("no quasi-static analysis, or not at its end")
    return _box(_figures(capacity.figures()) + _image(_png_of_curve(capacity), "capacity curve"))


def html_of_rows(rows: Iterable[dict[str, Any]], most: int = 60) -> str:
    """A table with the names of the first row as its head. most: rows that are shown."""
    rows = list(rows)
    names = list(dict.fromkeys(name for row in rows for name in row))
    head = "".join(f"<th>{html.escape(name)}</th>" for name in names)
    body = "".join("<tr>" + "".join(f"<td>{html.escape(_text(row.get(name, '')))}</td>" for name in names) + "</tr>" for row in rows[:most])
    more = f"<p>{len(rows) - most} rows more</p>" if len(rows) > most else ""
    return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>{more}"


def _checked(model: "Model") -> dict[str, Any]:
    """What `voussoir check` says of a model, by name."""
    found: dict[str, Any] = json.loads(model._with_file(lambda path: commands.call("check", path, "--format", "json")))
    return found


def figures_of_model(checked: Mapping[str, Any]) -> list[tuple[str, str]]:
    """Counts, mass and step, in words and with units."""
    mass = checked["mass"]
    return [("elements", f"{checked['elements']:,}"), ("joints", f"{checked['joints']:,} and {checked['base_joints']:,} with the base"),
            ("mass", f"{mass / 1e3:.2f} t" if mass >= 1000.0 else f"{mass:.1f} kg"), ("step", f"{1e6 * checked['step']:.3g} µs")]


def title_of(results: "Results") -> str:
    """The title of the case of a run, else the name of its folder."""
    with contextlib.suppress(ModuleNotFoundError):  # Python 3.10 does not read TOML
        return str(results.case.get("title") or results.folder.absolute().name)
    return results.folder.absolute().name


def figures_of_run(results: "Results") -> list[tuple[str, str]]:
    """State and main figures of a run, in words and with units."""
    summary = results.summary
    rows = [("state", _STATES.get(results.state, results.state) + (f", {summary['end_time']:.2f} s" if "end_time" in summary else ""))]
    if summary.get("failure"):
        rows.append(("lost", str(summary["failure"])))
    if results.capacity:
        return rows + results.capacity.figures()
    if summary.get("damage_grade", -1) >= 0:
        rows.append(("damage grade (EMS-98)", f"{summary['damage_grade']} of 5"))
    if "collapsed" in summary:
        rows.append(("collapsed", "no" if not summary["collapsed"] else f"yes, at {summary['collapse_time']:.2f} s"
                     if summary.get("collapse_time", -1.0) >= 0 else "yes"))
    if "first_crack_time" in summary:
        rows.append(("first crack", f"{summary['first_crack_time']:.2f} s" if summary["first_crack_time"] >= 0 else "none"))
    for name, words, factor, digits, unit in _OF_SUMMARY:
        value = summary.get(name)
        if isinstance(value, (int, float)) and value == value:
            rows.append((words, f"{factor * value:.{digits}f} {unit}"))
    return rows


_STATES = {"finished": "finished", "lost": "lost to a numerical failure", "goes on": "goes on", "stopped": "stopped, can go on"}
_OF_SUMMARY = (("fallen_mass_fraction", "fallen", 1e2, 1, "% of the mass"), ("peak_drift", "largest lean of a wall", 1e2, 2, "% of its height"),
               ("peak_base_shear", "largest base shear", 1e-3, 1, "kN"))


def _caption(results: "Results") -> str:
    return f"At {results.frames[-1].time:.2f} s. The redder, the more bonds are broken." if len(results.frames) else ""


# Pieces of HTML

def _box(inner: str) -> str:
    return f'<div style="{_STYLE}">{inner}</div>'


def _head(title: str, place: str = "") -> str:
    where = f' <span style="opacity:.7">{html.escape(place)}</span>' if place else ""
    return f"<div><b>{html.escape(title)}</b>{where}</div>"


def _figures(rows: Iterable[tuple[str, str]]) -> str:
    cells = "".join(f'<span><span style="opacity:.7">{html.escape(name)}</span>&ensp;{html.escape(value)}</span>' for name, value in rows)
    return f'<div style="display:flex;flex-wrap:wrap;gap:2px 24px;margin:4px 0 6px">{cells}</div>'


def _list(findings: Iterable[str]) -> str:
    lines = "".join(f"<li>{html.escape(finding)}</li>" for finding in findings)
    return f'<ul style="margin:2px 0 6px;padding-left:20px">{lines}</ul>' if lines else ""


def _image(png: bytes, words: str) -> str:
    if not png:
        return ""
    return f'<img alt="{html.escape(words)}" style="max-width:100%" src="data:image/png;base64,{base64.b64encode(png).decode()}">'


def _page(page: bytes, png: bytes, title: str, most: int | None, height: int, caption: str = "") -> str:
    """The page packed, in the place of which the picture stands until it is unpacked; the picture alone where the page is too large."""
    picture = _image(png, title) + (f'<div style="opacity:.7">{html.escape(caption)}</div>' if png and caption else "")
    if not page:
        return picture
    packed = gzip.compress(page, 9, mtime=0)
    if most is not None and len(packed) > most:
        return picture + f"<p>Its page has {len(packed) / 1e6:.1f} MB packed: .show() puts it here.</p>"
    name = f"voussoir-{secrets.token_hex(8)}"
    words = "".join(c for c in title if c.isalnum() or c in " ,.:-")
    script = _SCRIPT.replace("NAME", name).replace("TITLE", words).replace("HEIGHT", str(height))
    return f'<div id="{name}" data-page="{base64.b64encode(packed).decode()}">{picture}</div><script>{script}</script>'


def _text(value: Any) -> str:
    return f"{value:.4g}" if isinstance(value, float) else str(value)


# Pictures: none where matplotlib is not installed

def _png_of(results: "Results") -> bytes:
    try:
        from . import picture
    except ImportError:
        return b""
    return picture.png_of(results) if len(results.frames) else b""


def _png_of_model(model: "Model") -> bytes:
    """Of a run of no time: the model as it is built."""
    with tempfile.TemporaryDirectory(prefix="voussoir-") as scratch, contextlib.suppress(VoussoirError, ImportError):
        folder = pathlib.Path(scratch) / "run"
        sets = ["analysis=", "gravity.settle=false", "time.duration=0"]
        words = [word for key in sets for word in ("--set", key)]
        model._with_file(lambda path: commands.call("run", path, "-o", folder, "-j", 1, "--quiet", *words))
        from .results import Results
        with contextlib.closing(Results(folder)) as results:
            return _png_of(results)
    return b""


def _png_of_curve(capacity: "Capacity") -> bytes:
    try:
        import matplotlib.pyplot as plt

        from . import picture, plots
    except ImportError:
        return b""
    try:
        figure = plots.capacity([capacity._results])
    except VoussoirError:
        return b""
    plt.close(figure)
    return picture.png_of_figure(figure)


@contextlib.contextmanager
def _quiet() -> Iterator[None]:
    """Without the warnings of the program, which `check` and `run` have given already."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        yield
