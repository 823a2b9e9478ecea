#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""The first frequencies of a house in free vibration with time.multirate = 1, 2 and 4, and what becomes of its amplitude.

usage: multirate_frequencies.py [CASE [PROGRAM]]     default: flat20n, build/release/io/voussoir; about a minute of processor time

A pulse of 0.1 s along x and y, too weak to crack anything, no gravity, no damping; then 3.85 s of free vibration. The frequency is by how far
the phase of the strongest oscillation gets from the first half to the second, each under a Hann window. Needs h5py and numpy.
"""
import math
import pathlib
import subprocess
import sys
import tempfile

import h5py
import numpy as np

ROOT = pathlib.Path(__file__).resolve().parent.parent
RATES, FREE_FROM = (1, 2, 4), 0.15  # s
CASE = """include = "{case}"
[gravity]
settle = false
acceleration = [0.0, 0.0, 0.0]
[damping]
ratio = 0.0
[motion]
x = "pulse.csv"
y = "pulse.csv"
[time]
duration = 4.0
[output]
history_interval = 0.001
frame_interval = 1.0
"""


def pulse():
    rows = [(0.005 * i, 0.02 * math.sin(math.pi * min(0.05 * i, 1.0)) ** 2) for i in range(1001)]
    return "t [s], a [m/s2]\n" + "".join(f"{t:.3f}, {a:.8f}\n" for t, a in rows)


def phase_frequency(x, dt, guess):
    n = len(x) // 2
    at = np.arange(n)
    window = 1 - np.cos(2 * np.pi * (at + 0.5) / n)
    first, second = (np.angle(np.sum(window * x[k * n : (k + 1) * n] * np.exp(-2j * np.pi * guess * dt * (k * n + at)))) for k in (0, 1))
    return guess + ((second - first + np.pi) % (2 * np.pi) - np.pi) / (2 * np.pi * n * dt)


def frequency(x, dt):
    spectrum, f = np.abs(np.fft.rfft(x * np.hanning(len(x)), 8 * len(x))), np.fft.rfftfreq(8 * len(x), dt)
    guess = f[f > 2.0][np.argmax(spectrum[f > 2.0])]
    for _ in range(5):
        guess = phase_frequency(x, dt, guess)
    return guess


def main():
    case = sys.argv[1] if len(sys.argv) > 1 else "flat20n"
    program = sys.argv[2] if len(sys.argv) > 2 else str(ROOT / "build/release/io/voussoir")
    histories = {}
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        (work / "pulse.csv").write_text(pulse())
        (work / "free.toml").write_text(CASE.format(case=case))
        for rate in RATES:
            subprocess.run([program, "run", "free.toml", "-j", "1", "--set", f"time.multirate={rate}", "-o", str(rate)], cwd=work, check=True,
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            with h5py.File(work / str(rate) / "run.h5") as f:
                t = f["history/time"][:]
                histories[rate] = {(n, axis): f[f"history/{n}/displacement"][:, axis][t > FREE_FROM] for n in f["history"] if n != "time" for axis in (0, 1)}
    print("| point, axis | Hz, one rate | " + " | ".join(f"{r}: change" for r in RATES[1:]) + " | amplitude, last quarter over first: " +
          ", ".join(map(str, RATES)) + " |")
    print("|---" * (2 + len(RATES)) + "|")
    for key in histories[1]:
        found = [frequency(histories[r][key], t[1] - t[0]) for r in RATES]
        quarter = len(histories[1][key]) // 4
        kept = [np.abs(histories[r][key][-quarter:]).max() / np.abs(histories[r][key][:quarter]).max() for r in RATES]
        print(f"| {key[0]}, {'xyz'[key[1]]} | {found[0]:.4f} | " + " | ".join(f"{f / found[0] - 1:+.1e}" for f in found[1:]) + " | " +
              ", ".join(f"{k:.3f}" for k in kept) + " |")


if __name__ == "__main__":
    main()
