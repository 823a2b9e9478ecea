#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Two loose walls of 0.2 m with a roof by the equation of motion of a rocking frame, beside the runs of loose-walls.toml.

usage: rocking_frame.py TABLE.csv MOTIONS       e.g. rocking_frame.py results/loose-walls/table.csv motions

MOTIONS is the folder that `changed_motions` has filled. Under each of its motions that TABLE.csv has, the frame of two walls and a beam that
lies on them is integrated as one tilt [rad]: N. Makris and M. F. Vassiliou, Planar rocking response and stability analysis of an array of
free-standing columns capped with a freely supported rigid beam, Earthquake Engineering and Structural Dynamics 42 (2013), 431-449. It rocks as
one block of the same slenderness and the size (1 + 3 g)/(1 + 2 g) R, where g is the mass of the beam over that of the walls (for g = 0:
G. W. Housner, The behavior of inverted pendulum structures during earthquakes, Bulletin of the Seismological Society of America 53 (1963),
403-417). Vertical acceleration acts on the weight. Nothing slides. Prints a row for each run: when its mass lies half as high (a tilt of
60 degrees), by the equation and in the table.
"""
import csv
import math
import pathlib
import sys

import numpy as np

WIDTH, HEIGHT = 0.2, 2.4  # of a wall, m
ROOF = 3.4 * 0.2 * 700.0 / (2 * WIDTH * HEIGHT * 1800.0)  # its mass over that of the walls
SLOPE = math.atan2(WIDTH, HEIGHT)
RATE = 3 / (2 * math.hypot(WIDTH, HEIGHT)) * (1 + 2 * ROOF) / (1 + 3 * ROOF)  # p squared over gravity, 1/m
REBOUND = (1 - 1.5 * math.sin(SLOPE) ** 2 + 3 * ROOF * math.cos(2 * SLOPE)) / (1 + 3 * ROOF)  # of the rate of tilt at an impact
GRAVITY = 9.8             # m/s2
STEP, END = 1e-4, 10.0    # s
FALLEN = math.radians(60.0)


def acceleration(path, times):
    rows = np.loadtxt(path, delimiter=",", skiprows=2)
    return np.interp(times, rows[:, 0], rows[:, 1])


def falls_at(horizontal, vertical):
    """Time of overturning, s; -1: the frame stands at the end. Symplectic Euler; an impact where the tilt changes its sign."""
    tilt = speed = 0.0
    for step, (a, v) in enumerate(zip(horizontal, vertical)):
        weight = GRAVITY + v
        if tilt == 0.0:  # stands until the motion exceeds what the walls bear
            if abs(a) <= weight * math.tan(SLOPE):
                continue
            side = -math.copysign(1.0, a)
        else:
            side = math.copysign(1.0, tilt)
        speed -= STEP * RATE * (weight * math.sin(SLOPE * side - tilt) + a * math.cos(SLOPE * side - tilt))
        moved = tilt + STEP * speed
        if tilt * moved < 0.0:
            speed *= REBOUND
            at_rest = abs(speed) < 1e-3 and abs(a) <= weight * math.tan(SLOPE)
            moved, speed = (0.0, 0.0) if at_rest else (math.copysign(1e-12, moved), speed)
        tilt = moved
        if abs(tilt) > FALLEN:
            return step * STEP
    return -1.0


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: rocking_frame.py TABLE.csv MOTIONS")
    motions, times = pathlib.Path(sys.argv[2]), np.arange(0.0, END, STEP)
    told = agree = 0
    print("direction,record,falls at by the equation [s],falls at in the run [s]")
    with open(sys.argv[1], newline="") as table:
        for row in csv.DictReader(table):
            folder = motions / pathlib.Path(row["record"].replace("#", "-")).name
            if row["case"] != "walls-20" or row["scale"] or row.get("level") or row["status"] != "done" or not folder.is_dir():
                continue
            across = {"LTV": "T", "TLV": "L"}[row["direction"]]  # what shakes the walls across
            equation = falls_at(acceleration(folder / f"{across}.csv", times), acceleration(folder / "V.csv", times))
            run = float(row["collapse_time"])
            told += 1
            agree += (equation < 0) == (run < 0)
            print(f'{row["direction"]},{folder.name},{equation:.2f},{run:.2f}', flush=True)
    print(f"# {agree} of {told} agree in whether the walls fall")


if __name__ == "__main__":
    main()
