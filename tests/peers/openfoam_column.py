#!/usr/bin/python3
"""Runs a plane dam break of `eisph pareto` with OpenFOAM's interFoam (Debian package openfoam).

    tests/peers/openfoam_column.py --flow martin_moyce --spacing 0.0047625 --courant 1 --out out/peers/foam_12

The folder then holds what `eisph pareto --peers` reads: the depth of water in every column of cells, zero where it
is less than half a cell. Volume of fluid with air above, square cells, walls without friction, no turbulence model;
schemes and solvers as is usual for such flows. One process. The CPU time is what interFoam tells when it ends, its
start and the few states that it writes included.
"""

import argparse
import os
import shutil

import numpy
from openfoam import cpu_time, fields, fluids, header, read_scalars, run, schemes, solution, step_count, write_files
from peer import FLOWS, state_name, state_times, write_peer


def patches(walls, top):
    return f"boundaryField {{ walls {{ {walls} }} top {{ {top} }} sides {{ type empty; }} }}\n"


def case_files(flow, spacing, courant):
    """Text of every file of the case, by path."""
    nx, nz = round(flow["tank"] / spacing), round(flow["tank_height"] / spacing)
    lx, lz = nx * spacing, nz * spacing
    corners = " ".join(f"({x:.12g} {y:.12g} {z:.12g})" for z in (0, lz)
                       for x, y in ((0, 0), (lx, 0), (lx, spacing), (0, spacing)))
    centre_x, centre_z = (numpy.arange(nx) + 0.5) * spacing, (numpy.arange(nz) + 0.5) * spacing
    water = numpy.outer(centre_z < flow["height"], centre_x < flow["length"]).astype(int)
    alpha = "\n".join(str(value) for value in water.ravel())
    files = {
        "system/blockMeshDict": header("dictionary", "blockMeshDict") + f"""
convertToMeters 1;
vertices ({corners});
blocks (hex (0 1 2 3 4 5 6 7) ({nx} 1 {nz}) simpleGrading (1 1 1));
edges ();
boundary (
  walls {{ type wall; faces ((0 3 2 1) (0 4 7 3) (1 2 6 5)); }}
  top {{ type patch; faces ((4 5 6 7)); }}
  sides {{ type empty; faces ((0 1 5 4) (3 7 6 2)); }}
);
""",
        "system/controlDict": header("dictionary", "controlDict") + f"""
application interFoam;
startFrom startTime; startTime 0; stopAt endTime; endTime {flow["end"]};
deltaT {0.02 * courant * spacing:.6g}; adjustTimeStep yes; maxCo {courant:g}; maxAlphaCo {courant:g}; maxDeltaT 1;
writeControl adjustableRunTime; writeInterval {flow["interval"]};
writeFormat ascii; writePrecision 6; writeCompression off; timeFormat general; timePrecision 8;
""",
        "system/fvSchemes": schemes(),
        "system/fvSolution": solution("solver PCG; preconditioner DIC;"),
        **fluids(),
        **fields(f"nonuniform List<scalar> {nx * nz}\n(\n{alpha}\n)", patches),
    }
    return files, nx, nz


def read_depths(path, nx, nz, spacing):
    fraction = numpy.array(read_scalars(path, nx * nz))
    depth = fraction.reshape(nz, nx).sum(axis=0) * spacing
    depth[depth < 0.5 * spacing] = 0.0
    return depth


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--flow", choices=sorted(FLOWS), required=True)
    parser.add_argument("--spacing", type=float, required=True, help="side of the cells, m")
    parser.add_argument("--courant", type=float, default=1.0, help="largest Courant number")
    parser.add_argument("--out", required=True, help="folder of the run")
    options = parser.parse_args()
    flow = FLOWS[options.flow]
    case = os.path.join(options.out, "case")
    files, nx, nz = case_files(flow, options.spacing, options.courant)
    write_files(case, files)
    run("blockMesh", case)
    log = run("interFoam", case)

    centres = (numpy.arange(nx) + 0.5) * options.spacing
    for index, instant in enumerate(state_times(flow)):
        depths = read_depths(os.path.join(case, f"{instant:.8g}", "alpha.water"), nx, nz, options.spacing)
        numpy.savetxt(os.path.join(options.out, state_name(index)), numpy.column_stack([centres, depths]),
                      delimiter=",", header="x [m],depth [m]", comments="", fmt="%.9g")
    shutil.rmtree(case)
    write_peer(options.out, options.flow, "OpenFOAM interFoam", f"Courant {options.courant:g}", options.spacing,
               nx * nz, step_count(log), cpu_time(log))


if __name__ == "__main__":
    main()
