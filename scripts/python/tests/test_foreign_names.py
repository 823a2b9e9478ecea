# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Names in files of others that are not in UTF-8: of stones, and of a record."""

import math

import voussoir
from fixture import InAFolder

FACES = [(4, 3, 2, 1), (5, 6, 7, 8), (1, 2, 6, 5), (2, 3, 7, 6), (3, 4, 8, 7), (4, 1, 5, 8)]


def two_stones():
    """An OBJ of one stone on another."""
    lines = []
    for k in range(2):
        lines.append(f"o Pièce_{k}")
        lines += [f"v {x} {y} {z}" for z in (0.2 * k, 0.2 * k + 0.2) for x, y in ((0, 0), (0.4, 0), (0.4, 0.3), (0, 0.3))]
        lines += ["f " + " ".join(str(8 * k + i) for i in face) for face in FACES]
    return "\n".join(lines) + "\n"


def record():
    values = "".join(f"{0.02 * math.sin(0.06 * i):15.7E}" for i in range(20))
    return f"PEER NGA STRONG MOTION DATABASE RECORD\nMéxico, Peñón, 090\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 20, DT= .0050 SEC,\n{values}\n"


class ForeignNames(InAFolder):
    def model(self, encoding):
        (self.folder / "a.obj").write_bytes(two_stones().encode(encoding))
        (self.folder / "a.AT2").write_bytes(record().encode(encoding))
        model = voussoir.Model("Stones of a file in another encoding")
        model["gravity.settle"] = False
        model["time.duration"] = 0.02
        model.material("stone", density=2000.0, young=1e9, poisson=0.2)
        model["stones"] = [{"file": str(self.folder / "a.obj"), "unit": "m", "supports": ["Pièce_0"]}]
        model["motion.x"] = str(self.folder / "a.AT2")
        return model

    def test_they_are_utf8_everywhere(self):
        for encoding in ("latin-1", "utf-8-sig", "utf-16", "utf-16-le", "utf-16-be"):
            with self.subTest(encoding):
                model = self.model(encoding)
                text = model.describe()
                self.assertIn("Pièce_1", text)
                self.assertIn("México, Peñón, 090", text)
                model.view(self.folder / "model.html", overwrite=True).read_text(encoding="utf-8")
                run = model.run(self.folder / f"run-{encoding}", threads=1)
                self.assertEqual(list(run.elements.tag), ["Pièce_0", "Pièce_1"])

    def test_texts_of_run_h5_are_utf8(self):
        run = self.model("latin-1").run(self.folder / "run", threads=1)
        found = []

        def look(name, thing):
            texts = [v for v in thing.attrs.values() if isinstance(v, (str, bytes))]
            if getattr(thing, "dtype", None) is not None and thing.dtype.kind in "SO":
                texts += list(thing[()].ravel()) if thing.shape else [thing[()]]
            for text in texts:
                found.append(text.decode("utf-8") if isinstance(text, bytes) else text.encode("utf-8").decode("utf-8"))  # surrogates raise

        run.file.visititems(look)
        self.assertTrue(any("Pièce_0" in text for text in found))
