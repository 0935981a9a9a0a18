#!/usr/bin/python3
"""Runs the dam break against a block, scenes/block_impact.toml, with OpenFOAM's interFoam (Debian package openfoam).

    tests/peers/openfoam_block.py run --spacing 0.01 --out out/peers/block_10mm
    tests/peers/openfoam_block.py tables --runs out/peers/block_20mm out/peers/block_10mm --out assets/reference

The first makes the case, runs it in one process and re-tabulates it into the folder: pressures on the block, force,
levels, depths. The second writes the reference tables of the validation case block_impact from the last of the runs;
what the runs before it say differently is the uncertainty that the tables state.

Half of the tank up to its plane of symmetry, cells of the given size about the block, up to twice as long at the far
ends of the tank and up to four times as high under its top.
"""

import argparse
import json
import os
import re
import shutil

import numpy
from openfoam import (cpu_time, fields, fluids, header, read_scalars, run, schemes, solution, step_count, version,
                      write_files)

# m; the x axis along the tank, y = 0 the plane of symmetry, z upwards. Those of scenes/block_impact.toml.
LENGTH, HALF_WIDTH, HEIGHT = 1.8, 0.32, 0.8
RESERVOIR, DEPTH = 0.6, 0.4
FRONT, BACK, SIDE, TOP = 1.2, 1.36, 0.12, 0.16
PATCH = 0.04  # side of the squares of the block's front over which pressures are averaged
END = 0.7  # s
INTERVAL = 0.01  # s, between the fields of the water fraction
GAUGES = {"before": (1.18, 0.06), "beside": (1.28, 0.22), "behind": (1.6, 0.22)}  # x, y
DEPTH_TIMES = (0.2, 0.3, 0.4, 0.5, 0.6, 0.7)
DEPTH_CELL = 0.04
GAUGE_SIDE = 0.02
RUN_UP_REACH = 0.1
FIRST_RECORD = 0.25  # s, of the reference tables: before the wave is at the block
WINDOWS = (0.1, 0.2)  # s, from the arrival on, over which impulses are told
ROWS, COLUMNS = round(TOP / PATCH), round(SIDE / PATCH)


class Axis:
    """Cells along an axis: pieces from one end to the next, each a geometric progression of sizes."""

    def __init__(self, pieces):
        """pieces: (start, end, size of the first cell, size of the last)."""
        self.pieces = []
        edges = [pieces[0][0]]
        for start, end, first, last in pieces:
            length = end - start
            if first == last:
                cells, ratio = max(1, round(length / first)), 1.0
            else:
                common = (length - first) / (length - last)
                cells = max(2, round(1.0 + numpy.log(last / first) / numpy.log(common)))
                ratio = last / first
            sizes = ratio ** (numpy.arange(cells) / max(cells - 1, 1))
            edges.extend(start + length * numpy.cumsum(sizes) / sizes.sum())
            self.pieces.append((start, end, cells, ratio))
        self.edges = numpy.array(edges)
        self.ends = [piece[0] for piece in self.pieces] + [self.pieces[-1][1]]

    def overlaps(self, lower, upper):
        """Length that each cell shares with an interval, m."""
        shared = numpy.minimum(self.edges[1:], upper) - numpy.maximum(self.edges[:-1], lower)
        return numpy.maximum(shared, 0.0)


def axes(s):
    x = Axis([(0.0, RESERVOIR, 2 * s, s), (RESERVOIR, FRONT, s, s), (FRONT, BACK, s, s), (BACK, LENGTH, s, 1.5 * s)])
    y = Axis([(k * PATCH, (k + 1) * PATCH, s, s) for k in range(COLUMNS)] + [(SIDE, HALF_WIDTH, s, s)])
    z = Axis([(k * PATCH, (k + 1) * PATCH, s, s) for k in range(ROWS)]
             + [(TOP, DEPTH, s, 2 * s), (DEPTH, HEIGHT, 2 * s, 4 * s)])
    return x, y, z


def in_block(x, y, z):
    return FRONT < x < BACK and y < SIDE and z < TOP


class Mesh:
    """Blocks of blockMesh about the block that is left out."""

    def __init__(self, spacing):
        self.x, self.y, self.z = axes(spacing)
        self.blocks = [(i, j, k) for k in range(len(self.z.pieces)) for j in range(len(self.y.pieces))
                       for i in range(len(self.x.pieces)) if not in_block(*self.centre(i, j, k))]

    def centre(self, i, j, k):
        return tuple(0.5 * (axis.ends[n] + axis.ends[n + 1]) for axis, n in zip((self.x, self.y, self.z), (i, j, k)))

    def vertex(self, i, j, k):
        return i + len(self.x.ends) * (j + len(self.y.ends) * k)

    def cell_places(self):
        """Indices along x, y and z of all cells in OpenFOAM's order: by block, x fastest."""
        places = []
        starts = [numpy.cumsum([0] + [piece[2] for piece in axis.pieces]) for axis in (self.x, self.y, self.z)]
        for block in self.blocks:
            ranges = [numpy.arange(starts[a][n], starts[a][n + 1]) for a, n in enumerate(block)]
            z, y, x = numpy.meshgrid(ranges[2], ranges[1], ranges[0], indexing="ij")
            places.append(numpy.column_stack([x.ravel(), y.ravel(), z.ravel()]))
        return numpy.concatenate(places)

    def faces(self):
        """Outer faces by patch, each as its four vertices, seen from outside against the clock."""
        blocks = set(self.blocks)
        patches = {}
        for i, j, k in self.blocks:
            v = {(a, b, c): self.vertex(i + a, j + b, k + c) for a in (0, 1) for b in (0, 1) for c in (0, 1)}
            sides = {
                (-1, 0, 0): (v[0, 0, 0], v[0, 0, 1], v[0, 1, 1], v[0, 1, 0]),
                (1, 0, 0): (v[1, 0, 0], v[1, 1, 0], v[1, 1, 1], v[1, 0, 1]),
                (0, -1, 0): (v[0, 0, 0], v[1, 0, 0], v[1, 0, 1], v[0, 0, 1]),
                (0, 1, 0): (v[0, 1, 0], v[0, 1, 1], v[1, 1, 1], v[1, 1, 0]),
                (0, 0, -1): (v[0, 0, 0], v[0, 1, 0], v[1, 1, 0], v[1, 0, 0]),
                (0, 0, 1): (v[0, 0, 1], v[1, 0, 1], v[1, 1, 1], v[0, 1, 1]),
            }
            for step, face in sides.items():
                beside = (i + step[0], j + step[1], k + step[2])
                if beside not in blocks:
                    patches.setdefault(self.patch_name(beside, step), []).append(face)
        return patches

    def patch_name(self, beside, step):
        """Patch of a face towards the place `beside` where there are no cells."""
        i, j, k = beside
        if 0 <= i < len(self.x.pieces) and 0 <= j < len(self.y.pieces) and 0 <= k < len(self.z.pieces):
            return f"front_{k + 1}_{j + 1}" if step == (1, 0, 0) else "block_rest"
        if step == (0, 0, 1):
            return "top"
        return "symmetry" if step == (0, -1, 0) else "walls"

    def dictionary(self):
        vertices = "\n".join(f"  ({x:.12g} {y:.12g} {z:.12g})" for z in self.z.ends for y in self.y.ends
                             for x in self.x.ends)
        lines = []
        for i, j, k in self.blocks:
            corners = " ".join(str(self.vertex(i + a, j + b, k + c)) for a, b, c in
                               ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)))
            along = [axis.pieces[n] for axis, n in zip((self.x, self.y, self.z), (i, j, k))]
            cells = " ".join(str(piece[2]) for piece in along)
            ratios = " ".join(f"{piece[3]:.12g}" for piece in along)
            lines.append(f"  hex ({corners}) ({cells}) simpleGrading ({ratios})")
        boundary = []
        for name, faces in self.faces().items():
            kind = {"top": "patch", "symmetry": "symmetryPlane"}.get(name, "wall")
            listed = " ".join("({} {} {} {})".format(*face) for face in faces)
            boundary.append(f"  {name} {{ type {kind}; faces ({listed}); }}")
        blocks, boundary = "\n".join(lines), "\n".join(boundary)
        return header("dictionary", "blockMeshDict") + f"""
convertToMeters 1;
vertices (
{vertices}
);
blocks (
{blocks}
);
edges ();
boundary (
{boundary}
);
"""


def patches(walls, top):
    return f'boundaryField {{ "(walls|front_.*|block_rest)" {{ {walls} }} top {{ {top} }} ' \
           "symmetry { type symmetryPlane; } }\n"


def functions(spacing):
    """Pressures on the squares of the block's front and the force on the block at every step."""
    squares = "\n".join(f"""
  front_{row}_{column} {{
    type surfaceFieldValue; libs ("libfieldFunctionObjects.so"); writeControl timeStep; log no; writeFields no;
    regionType patch; name front_{row}_{column}; operation areaAverage; fields (p);
  }}""" for row in range(1, ROWS + 1) for column in range(1, COLUMNS + 1))
    return f"""
functions {{{squares}
  force {{
    type forces; libs ("libforces.so"); writeControl timeStep; log no;
    patches ("front_.*" block_rest); rho rho; p p; U U; CofR ({FRONT} 0 0);
  }}
  water {{
    type writeObjects; libs ("libutilityFunctionObjects.so"); objects (alpha.water); writeOption anyWrite;
    writeControl adjustableRunTime; writeInterval {INTERVAL};
  }}
}}
"""


def case_files(mesh, spacing, courant):
    """Text of every file of the case, by path."""
    places = mesh.cell_places()
    x = 0.5 * (mesh.x.edges[1:] + mesh.x.edges[:-1])[places[:, 0]]
    z = 0.5 * (mesh.z.edges[1:] + mesh.z.edges[:-1])[places[:, 2]]
    water = ((x < RESERVOIR) & (z < DEPTH)).astype(int)
    alpha = f"nonuniform List<scalar> {len(water)}\n(\n" + "\n".join(str(value) for value in water) + "\n)"
    pressure = "solver GAMG; smoother DIC; nPreSweeps 0; nPostSweeps 2;"
    return {
        "system/blockMeshDict": mesh.dictionary(),
        "system/controlDict": header("dictionary", "controlDict") + f"""
application interFoam;
startFrom startTime; startTime 0; stopAt endTime; endTime {END};
deltaT {0.02 * spacing:.6g}; adjustTimeStep yes; maxCo {courant:g}; maxAlphaCo {courant:g}; maxDeltaT 0.001;
writeControl adjustableRunTime; writeInterval {END};
writeFormat ascii; writePrecision 6; writeCompression off; timeFormat general; timePrecision 8;
""" + functions(spacing),
        "system/fvSchemes": schemes(),
        "system/fvSolution": solution(pressure),
        **fluids(),
        **fields(alpha, patches),
    }


class WaterFraction:
    """The water fraction on the cells, as an array over x, y and z; zero inside the block."""

    def __init__(self, mesh, path):
        places = mesh.cell_places()
        self.mesh = mesh
        self.values = numpy.zeros([len(axis.edges) - 1 for axis in (mesh.x, mesh.y, mesh.z)])
        self.values[tuple(places.T)] = read_scalars(path, len(places))

    def column(self, x, y, side):
        """Mean over a square about (x, y), by height: over the part of the square where there is room."""
        along_x = self.mesh.x.overlaps(x - 0.5 * side, x + 0.5 * side)
        along_y = self.mesh.y.overlaps(y - 0.5 * side, y + 0.5 * side)
        return numpy.einsum("i,j,ijk->k", along_x, along_y, self.values) / side**2

    def level(self, x, y):
        """Height at which the fraction first falls through one half on the way up from the floor, m."""
        fraction = self.column(x, y, GAUGE_SIDE)
        heights = numpy.append(0.0, centres(self.mesh.z))
        fraction = numpy.append(fraction[0], fraction)
        dry = numpy.flatnonzero(fraction < 0.5)
        if len(dry) == 0 or dry[0] == 0:
            return 0.0
        upper = dry[0]
        part = (fraction[upper - 1] - 0.5) / (fraction[upper - 1] - fraction[upper])
        return heights[upper - 1] + part * (heights[upper] - heights[upper - 1])

    def depth(self, x, y):
        """Volume of water over a square of side DEPTH_CELL about (x, y), over its area, m."""
        return float(numpy.dot(self.column(x, y, DEPTH_CELL), numpy.diff(self.mesh.z.edges)))

    def run_up(self):
        """Height of the highest water within RUN_UP_REACH of the block's front and across its width, m."""
        x, y = centres(self.mesh.x), centres(self.mesh.y)
        near = self.values[(x > FRONT - RUN_UP_REACH) & (x < FRONT)][:, y < SIDE]
        fraction, heights = numpy.append(near.max(axis=(0, 1)), 0.0), numpy.append(centres(self.mesh.z), HEIGHT)
        wet = numpy.flatnonzero(fraction >= 0.5)
        if len(wet) == 0:
            return 0.0
        last = wet[-1]
        part = (fraction[last] - 0.5) / (fraction[last] - fraction[last + 1])
        return heights[last] + part * (heights[last + 1] - heights[last])

    def section(self):
        """Points (x, z) where the fraction is one half in the cells at the plane of symmetry, between the centres
        of neighbours; cells of the block have no surface."""
        x, z = centres(self.mesh.x), centres(self.mesh.z)
        plane = self.values[:, 0, :].copy()
        plane[numpy.ix_((x > FRONT) & (x < BACK), z < TOP)] = numpy.nan
        points = []
        for axis in (0, 1):
            one, other = (plane[:-1], plane[1:]) if axis == 0 else (plane[:, :-1], plane[:, 1:])
            with numpy.errstate(invalid="ignore", divide="ignore"):
                crossing = (one - 0.5) * (other - 0.5) < 0.0
                part = (one - 0.5) / (one - other)
            for i, k in zip(*numpy.nonzero(crossing)):
                step = part[i, k]
                points.append((x[i] + (step * (x[i + 1] - x[i]) if axis == 0 else 0.0),
                               z[k] + (step * (z[k + 1] - z[k]) if axis == 1 else 0.0)))
        return sorted(points)


def centres(axis):
    return 0.5 * (axis.edges[1:] + axis.edges[:-1])


def step_means(times, values, instants):
    """Means over intervals of the length of the steps of `instants` about each of them, by the trapezium rule: they
    keep the integral over time."""
    integral = numpy.append(0.0, numpy.cumsum(0.5 * (values[1:] + values[:-1]) * numpy.diff(times)))
    half = 0.5 * (instants[1] - instants[0])
    ends = numpy.interp(instants + half, times, integral)
    return (ends - numpy.interp(instants - half, times, integral)) / (2.0 * half)


def read_pressures(case):
    """Times of the steps and pressures on the squares, Pa, by row and column."""
    pressures = {}
    for row in range(1, ROWS + 1):
        for column in range(1, COLUMNS + 1):
            path = os.path.join(case, "postProcessing", f"front_{row}_{column}", "0", "surfaceFieldValue.dat")
            times, pressures[row, column] = numpy.loadtxt(path, unpack=True)
    return times, pressures


def read_force(case):
    """Times and the force on the half of the block, N: x, z."""
    rows = []
    with open(os.path.join(case, "postProcessing", "force", "0", "force.dat")) as file:
        for line in file:
            if not line.startswith("#"):
                numbers = re.findall(r"[-+.\deE]+", line)
                rows.append([float(numbers[n]) for n in (0, 1, 3)])
    return numpy.array(rows).T


def write_table(path, comments, names, columns):
    with open(path, "w") as file:
        for comment in comments:
            file.write(f"# {comment}\n")
        file.write(",".join(names) + "\n")
        for row in zip(*columns):
            file.write(",".join(f"{value:.6g}" for value in row) + "\n")


def tabulate(mesh, case, out):
    """Writes the tables of one run: block.csv by time, levels.csv, depths.csv and section.csv."""
    times, pressures = read_pressures(case)
    instants = numpy.arange(1, round(END / 0.001)) * 0.001
    names, columns = ["time [s]"], [instants]
    for (row, column), values in pressures.items():
        names.append(f"p{row}_{column} [Pa]")
        columns.append(step_means(times, values, instants))
    force_times, force_x, force_z = read_force(case)
    for name, values in (("force_x [N]", force_x), ("force_z [N]", force_z)):
        names.append(name)
        columns.append(step_means(force_times, values, instants))
    write_table(os.path.join(out, "block.csv"), [], names, columns)

    levels, depths, section = [], [], []
    cells = [((i + 0.5) * DEPTH_CELL, (j + 0.5) * DEPTH_CELL) for j in range(round(HALF_WIDTH / DEPTH_CELL))
             for i in range(round(LENGTH / DEPTH_CELL))]
    for n in range(1, round(END / INTERVAL) + 1):
        instant = n * INTERVAL
        water = WaterFraction(mesh, os.path.join(case, f"{instant:.8g}", "alpha.water"))
        levels.append([instant] + [water.level(*GAUGES[name]) for name in GAUGES] + [water.run_up()])
        if any(abs(instant - time) < 1e-9 for time in DEPTH_TIMES):
            depths.append([water.depth(*cell) for cell in cells])
            section.extend((instant, *point) for point in water.section())
    write_table(os.path.join(out, "levels.csv"), [], ["time [s]"] + [f"{name} [m]" for name in GAUGES] + ["run_up [m]"],
                numpy.array(levels).T)
    write_table(os.path.join(out, "depths.csv"), [],
                ["x [m]", "y [m]"] + [f"depth_{round(1000 * time)}ms [m]" for time in DEPTH_TIMES],
                [*numpy.array(cells).T, *depths])
    write_table(os.path.join(out, "section.csv"), [], ["time [s]", "x [m]", "z [m]"], numpy.array(section).T)


def run_case(options):
    mesh = Mesh(options.spacing)
    case = os.path.join(options.out, "case")
    write_files(case, case_files(mesh, options.spacing, options.courant))
    run("blockMesh", case)
    finish(options.out, mesh, case, run("interFoam", case), options)
    shutil.rmtree(case)


def finish(out, mesh, case, log, options):
    tabulate(mesh, case, out)
    figures = {"spacing": options.spacing, "courant": options.courant, "cells": len(mesh.cell_places()),
               "steps": step_count(log), "cpu_time": cpu_time(log), "version": version(log)}
    with open(os.path.join(out, "run.json"), "w") as file:
        json.dump(figures, file, indent=2)
    print("block, {} mm: {cells} cells, {steps} steps, {cpu_time:.0f} s of CPU time".format(
        1000 * options.spacing, **figures))


class Run:
    """A finished run."""

    def __init__(self, folder):
        with open(os.path.join(folder, "run.json")) as file:
            self.figures = json.load(file)
        self.folder = folder
        self.spacing = 1000 * self.figures["spacing"]

    def table(self, name):
        """Columns of a table by their names without units."""
        path = os.path.join(self.folder, name + ".csv")
        with open(path) as file:
            names = [column.split(" ")[0] for column in file.readline().strip().split(",")]
        return dict(zip(names, numpy.loadtxt(path, delimiter=",", skiprows=1, unpack=True)))

    def rows(self):
        """Time and the mean pressure over the width of the front by row, Pa."""
        block = self.table("block")
        return block["time"], [sum(block[f"p{row}_{column}"] for column in range(1, COLUMNS + 1)) / COLUMNS
                               for row in range(1, ROWS + 1)]

    def arrival(self):
        """Time at which the lowest row comes to a tenth of rho g H, s."""
        time, rows = self.rows()
        level = 0.1 * 1000.0 * 9.81 * DEPTH
        after = numpy.flatnonzero((rows[0] >= level) & (time > 0.1))[0]
        part = (level - rows[0][after - 1]) / (rows[0][after] - rows[0][after - 1])
        return time[after - 1] + part * (time[after] - time[after - 1])

    def impulses(self, window):
        """Integrals of the rows over `window` from the arrival on, Pa s."""
        time, rows = self.rows()
        fine = self.arrival() + numpy.linspace(0.0, window, 2001)
        return [float(numpy.mean(numpy.interp(fine, time, row)) * window) for row in rows]


def uncertainty(runs):
    """Lines that say how the runs differ, and what the finest is taken to lack if the error is of second order: on 40,
    20, 13.3 and 10 mm the impulse over 0.2 s is 728, 823, 866 and 880 Pa s at the foot, 31, 60, 71 and 75 at the top."""
    lines = []
    for run_ in runs:
        figures = run_.figures
        impulses = "; ".join("{} s: {}".format(window, ", ".join(f"{value:.0f}" for value in run_.impulses(window)))
                             for window in WINDOWS)
        lines.append(f"{run_.spacing:.3g} mm ({figures['cells']} cells, {figures['steps']} steps, "
                     f"{figures['cpu_time']:.0f} s of CPU time): arrival at {1000 * run_.arrival():.1f} ms, impulse of the "
                     f"rows from foot to top [Pa s] from then on over {impulses}.")
    if len(runs) > 1:
        before, last = runs[-2:]
        part = 1.0 / ((before.spacing / last.spacing) ** 2 - 1.0)
        lacking = [100.0 * part * (fine / coarse - 1.0) / (fine / coarse) for coarse, fine in
                   zip(before.impulses(WINDOWS[-1]), last.impulses(WINDOWS[-1]))]
        lines.append(f"Estimated uncertainty, from the last two by second order: impulses over {WINDOWS[-1]} s "
                     + ", ".join(f"{value:+.0f}" for value in lacking)
                     + f" %, arrival {1000 * part * (last.arrival() - before.arrival()):+.1f} ms.")
    return lines


def write_reference(options):
    runs = [Run(folder) for folder in options.runs]
    finest = runs[-1]
    figures = finest.figures
    about = [
        f"OpenFOAM {figures['version']}, interFoam (Debian package openfoam), run by tests/peers/openfoam_block.py",
        "Dam break against a block, scenes/block_impact.toml. Volume of fluid with air above, free slip at all walls, "
        "laminar, plane of symmetry y = 0; half of the tank.",
        f"Cells of {finest.spacing:.3g} mm about the block, up to twice as long in the reservoir and four times as high "
        f"under the top; largest Courant number {figures['courant']:g}; Euler in time, linearUpwind for momentum, "
        "vanLeer and MULES with cAlpha = 1 for the water fraction, 3 PISO corrections.",
    ]

    def write(name, meaning, names, columns):
        write_table(os.path.join(options.out, f"block_impact_{name}.csv"), about + meaning, names, columns)

    block = finest.table("block")
    late = block["time"] > FIRST_RECORD
    names = [name for name in block if name != "time"]
    write("pressure", [
        "Pressure on squares of 40 mm of the block's front, p<row from the foot>_<column from the plane of symmetry>, and "
        "force on the half of the block, means over 1 ms. Means over a row by mesh:", *uncertainty(runs)],
        ["time [s]"] + [name + (" [N]" if name.startswith("force") else " [Pa]") for name in names],
        [block["time"][late]] + [block[name][late] for name in names])

    levels = [run_.table("levels") for run_ in runs]
    write("level", [
        "Level (where a vertical line from the floor up leaves the water) at gauges, x, y [m]: "
        + ", ".join("{} {} {}".format(name, *place) for name, place in GAUGES.items())
        + f"; run_up: height of the highest water within {1000 * RUN_UP_REACH:g} mm of the front, across its half width.",
        "RMS of the other meshes against this one from 0.28 s on [mm]: " + "; ".join(
            "{:.3g} mm: {}".format(run_.spacing, ", ".join(
                f"{name} {1000 * rms(table[name], levels[-1][name], table['time'] > FIRST_RECORD):.1f}"
                for name in levels[-1] if name != "time"))
            for run_, table in zip(runs[:-1], levels))],
        [name + (" [s]" if name == "time" else " [m]") for name in levels[-1]],
        levels[-1].values())

    depths = [run_.table("depths") for run_ in runs]
    times = [name for name in depths[-1] if name.startswith("depth")]
    write("depth", [
        "Volume of water over squares of 40 mm of floor over their area; on the block the water above its top.",
        "RMS of the other meshes against this one from x = 0.6 m on [mm]: " + "; ".join(
            "{:.3g} mm: {}".format(run_.spacing, ", ".join(
                f"{name} {1000 * rms(table[name], depths[-1][name], table['x'] > RESERVOIR):.1f}" for name in times))
            for run_, table in zip(runs[:-1], depths))],
        [name + " [m]" for name in depths[-1]], depths[-1].values())

    section = finest.table("section")
    near = (section["x"] > 0.8) & (section["time"] > FIRST_RECORD)
    write("section", ["Free surface at the plane of symmetry: points where the water fraction is one half."],
          ["time [s]", "x [m]", "z [m]"], [section[name][near] for name in ("time", "x", "z")])
    print("\n".join(uncertainty(runs)))


def rms(values, reference, chosen):
    return numpy.sqrt(numpy.mean((values[chosen] - reference[chosen]) ** 2))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(required=True)
    one = commands.add_parser("run", help="make the case, run it, tabulate it")
    one.add_argument("--spacing", type=float, required=True, help="side of the cells about the block, m; divides 0.04")
    one.add_argument("--courant", type=float, default=0.5, help="largest Courant number")
    one.add_argument("--out", required=True, help="folder of the run")
    one.set_defaults(carry_out=run_case)
    tables = commands.add_parser("tables", help="write the reference tables of the finest of some runs")
    tables.add_argument("--runs", nargs="+", required=True, help="folders of runs, the finest last")
    tables.add_argument("--out", required=True, help="folder of the tables")
    tables.set_defaults(carry_out=write_reference)
    options = parser.parse_args()
    options.carry_out(options)


if __name__ == "__main__":
    main()
