# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Opens run.xdmf of a run in each XDMF reader of ParaView and compares what it gives with run.h5.

usage: voussoir report --paraview DIR && pvpython scripts/check_paraview.py DIR
Needs python3-paraview (0.5 GB) and hdf5-tools. Compared: times, numbers of cells and vertices, and in the last frame the displacement and the
broken fraction of every cell, its material, and where its vertices are. Exit code 1 where something differs.
"""

import os
import subprocess
import sys
import tempfile

import numpy as np
from paraview import servermanager
from paraview.simple import Delete, OpenDataFile, Xdmf3ReaderS, Xdmf3ReaderT, XDMFReader
from paraview.vtk.util.numpy_support import vtk_to_numpy

folder = os.path.abspath(sys.argv[1])


def read(name, dtype, *selection):
    """A dataset of run.h5. Not read by h5py, whose HDF5 library conflicts with ParaView's in one process."""
    with tempfile.NamedTemporaryFile() as out:
        command = ["h5dump", "-d", name, *selection, "-b", "LE", "-o", out.name, folder + "/run.h5"]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        return np.fromfile(out.name, dtype)


def last_row(name, frames, *width):
    """The last row of a dataset of frames."""
    first = ",".join(["%d" % (frames - 1)] + ["0"] * len(width))
    count = ",".join(["1"] + ["%d" % w for w in width])
    return read(name, "<f4", "-s", first, "-c", count).reshape(width).astype(float)


def turned(q, v):
    """Vectors turned by unit quaternions (w, x, y, z), row by row."""
    u = q[:, 1:]
    t = 2 * np.cross(u, v)
    return v + q[:, :1] * t + np.cross(u, t)


class Expected:
    """Expected values, from run.h5."""

    def __init__(self):
        self.times = read("/frames/time", "<f8")
        self.element = read("/model/cell_element", "<i4")
        self.material = read("/model/element/material", "<i4")[self.element]
        start = read("/model/element/position0", "<f8").reshape(-1, 3)
        vertex = read("/model/vertex", "<f8").reshape(-1, 3)
        n, frames = len(start), len(self.times)
        moved = last_row("/frames/displacement", frames, n, 3)
        self.broken = last_row("/frames/broken", frames, n)[self.element]
        self.displacement = moved[self.element]
        first = read("/model/element/first_vertex", "<i4")
        owner = np.repeat(np.arange(n), np.diff(np.append(first, len(vertex))))
        q = last_row("/frames/quaternion", frames, n, 4)
        self.points = (start + moved)[owner] + turned(q[owner], vertex - start[owner])


def check(reader, expected):
    """Differences between a reader's data and the expected values."""
    faults = []

    def same(what, got, wanted, tolerance=0.0):
        got, wanted = np.asarray(got), np.asarray(wanted)
        if got.shape != wanted.shape:
            faults.append("%s: %s values, expected %s" % (what, got.shape, wanted.shape))
        elif got.size and not np.max(np.abs(got - wanted)) <= tolerance:
            faults.append("%s: off by %g" % (what, np.max(np.abs(got - wanted))))

    times = list(reader.TimestepValues)
    same("times", times, expected.times, 1e-9)
    reader.UpdatePipeline(times[-1])
    data = servermanager.Fetch(reader)
    while data.IsA("vtkMultiBlockDataSet"):
        data = data.GetBlock(0)
    cells = data.GetCellData()
    same("cells", data.GetNumberOfCells(), len(expected.element))
    # a float32 at 16 m or less is within 1 um
    same("points", vtk_to_numpy(data.GetPoints().GetData()), expected.points, 2e-6)
    same("displacement", vtk_to_numpy(cells.GetArray("displacement")), expected.displacement, 2e-6)
    same("broken", vtk_to_numpy(cells.GetArray("broken")), expected.broken, 0.0)
    same("element", vtk_to_numpy(cells.GetArray("element")), expected.element)
    same("material", vtk_to_numpy(cells.GetArray("material")), expected.material)
    volumes = [data.GetCell(c).GetCellType() for c in range(min(1000, data.GetNumberOfCells()))]
    if set(volumes) - {12, 13}:
        faults.append("cells of other types than hexahedron and wedge: %s" % sorted(set(volumes)))
    return faults


def main():
    expected, bad = Expected(), False
    os.chdir("/")  # run.xdmf must be found from anywhere
    for make in (XDMFReader, Xdmf3ReaderS, Xdmf3ReaderT):
        name = make.__name__
        reader = make(FileNames=[folder + "/run.xdmf"]) if name == "XDMFReader" else make(FileName=[folder + "/run.xdmf"])
        faults = check(reader, expected)
        Delete(reader)
        farthest = np.max(np.linalg.norm(expected.displacement, axis=1))
        print("%-13s %d times, %d cells, displaced by up to %.3f m: %s" % (
            name, len(expected.times), len(expected.element), farthest, "as in run.h5" if not faults else "; ".join(faults)))
        bad = bad or bool(faults)
    sys.exit(bad)


main()
