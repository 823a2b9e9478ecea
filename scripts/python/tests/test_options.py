# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Numbers of options are refused as those of keys are, before anything is read or computed."""

import voussoir
from fixture import InAFolder, blocks

MOTION = [("--target", "ec8:1:B:1e300g"), ("--target", "ec8:1:B:nan"), ("--target", "ec8:1:B:0.3g", "--fit", "1e-300", "1e300"),
          ("--target", "ec8:1:B:0.3g", "--fit", "0.1", "nan"), ("--until", "inf"), ("--until", "nan"), ("--until", "1e300"), ("--from", "nan"),
          ("--to", "1e300"), ("--taper", "1e300"), ("--intensity", "nan"), ("--intensity", "1e-300"), ("--damping", "nan"), ("--dt", "1e300")]
RUN = [("assess", "--time", "nan"), ("assess", "--time", "1e300"), ("assess", "--levels", "nan"), ("assess", "--levels", "1,1e300"),
       ("assess", "--damping", "nan"), ("report", "--stills", "nan"), ("report", "--stills", "1e300"), ("report", "--film", "a.gif", "--speed", "nan"),
       ("report", "--film", "a.gif", "--rate", "1e9"), ("report", "--modes", "1e9"), ("resume", "--until", "nan"), ("resume", "--until", "1e300")]
CASE = [("limit", "--at", "nan,0,0"), ("limit", "--at", "1e300,0,0"), ("limit", "--path", "0,0,0,0,0,inf"), ("limit", "--force", "1e300", "--at", "0,0,0"),
        ("limit", "--direction", "nan,0,0"), ("limit", "--facets", "1e9"), ("modes", "--count", "1e9"), ("bench", "--after", "nan"),
        ("bench", "--steps", "1e30"), ("run", "--report-every", "nan"), ("run", "--checkpoint-every", "nan"), ("run", "--checkpoint-simulated", "0"),
        ("run", "--scale", "nan"), ("run", "--scale", "1e300"), ("run", "--duration", "1e300"), ("run", "--dt", "1e-300"), ("run", "--frames", "1e-300"),
        ("run", "-j", "1e300")]


class Options(InAFolder):
    def refused(self, *words):
        with self.subTest(" ".join(map(str, words))), self.assertRaises(voussoir.InputError):
            voussoir.call(*words, folder=self.folder)

    def test_impossible_numbers(self):
        case = blocks().write(self.folder / "blocks.toml")
        run = blocks().run(self.folder / "run", until=0.06, threads=1, progress=False).folder
        for words in MOTION:
            self.refused("motion", "bam-like", *words)
        for command, *words in RUN:
            self.refused(command, run, *words)
        for command, *words in CASE:
            self.refused(command, case, *words)
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["blocks.toml", "run"])
