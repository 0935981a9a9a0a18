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
import re
import shutil
import subprocess
import sys

import numpy
from peer import FLOWS, state_name, state_times, write_peer

BASHRC = "/usr/share/openfoam/etc/bashrc"


def header(kind, name):
    return f"FoamFile {{ version 2.0; format ascii; class {kind}; object {name}; }}\n"


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
        "system/fvSchemes": header("dictionary", "fvSchemes") + """
ddtSchemes { default Euler; }
gradSchemes { default Gauss linear; }
divSchemes {
  div(rhoPhi,U) Gauss linearUpwind grad(U);
  div(phi,alpha) Gauss vanLeer;
  div(phirb,alpha) Gauss linear;
  div(((rho*nuEff)*dev2(T(grad(U))))) Gauss linear;
}
laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes { default linear; }
snGradSchemes { default corrected; }
""",
        "system/fvSolution": header("dictionary", "fvSolution") + """
solvers {
  "alpha.water.*" { nAlphaCorr 2; nAlphaSubCycles 1; cAlpha 1; MULESCorr yes; nLimiterIter 5;
                    solver smoothSolver; smoother symGaussSeidel; tolerance 1e-8; relTol 0; }
  "pcorr.*" { solver PCG; preconditioner DIC; tolerance 1e-5; relTol 0; }
  p_rgh { solver PCG; preconditioner DIC; tolerance 1e-7; relTol 0.05; }
  p_rghFinal { $p_rgh; relTol 0; }
  U { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-6; relTol 0; }
}
PIMPLE { momentumPredictor no; nOuterCorrectors 1; nCorrectors 3; nNonOrthogonalCorrectors 0; }
relaxationFactors { equations { ".*" 1; } }
""",
        "constant/g": header("uniformDimensionedVectorField", "g") + """
dimensions [0 1 -2 0 0 0 0];
value (0 0 -9.81);
""",
        "constant/transportProperties": header("dictionary", "transportProperties") + """
phases (water air);
water { transportModel Newtonian; nu 1e-06; rho 1000; }
air { transportModel Newtonian; nu 1.48e-05; rho 1.2; }
sigma 0.07;
""",
        "constant/turbulenceProperties": header("dictionary", "turbulenceProperties") + "simulationType laminar;\n",
        "0/U": header("volVectorField", "U") + """
dimensions [0 1 -1 0 0 0 0];
internalField uniform (0 0 0);
""" + patches("type slip;", "type pressureInletOutletVelocity; value uniform (0 0 0);"),
        "0/p_rgh": header("volScalarField", "p_rgh") + """
dimensions [1 -1 -2 0 0 0 0];
internalField uniform 0;
""" + patches("type fixedFluxPressure; value uniform 0;", "type totalPressure; p0 uniform 0;"),
        "0/alpha.water": header("volScalarField", "alpha.water") + f"""
dimensions [0 0 0 0 0 0 0];
internalField nonuniform List<scalar> {nx * nz}
(
{alpha}
)
;
""" + patches("type zeroGradient;", "type inletOutlet; inletValue uniform 0; value uniform 0;"),
    }
    return files, nx, nz


def run(command, folder):
    """Output of an OpenFOAM program; ends this one if it fails."""
    line = f"source {BASHRC} >/dev/null 2>&1; exec {command}"
    done = subprocess.run(["bash", "-c", line], cwd=folder, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{command} failed in {folder}:\n{(done.stdout + done.stderr)[-2000:]}")
    return done.stdout


def read_depths(path, nx, nz, spacing):
    with open(path) as file:
        text = file.read()
    uniform = re.search(r"internalField\s+uniform\s+(\S+);", text)
    if uniform:
        fraction = numpy.full(nx * nz, float(uniform.group(1)))
    else:
        values = re.search(r"internalField\s+nonuniform[^(]*\(([^)]*)\)", text).group(1)
        fraction = numpy.array(values.split(), dtype=float)
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
    for name, text in files.items():
        path = os.path.join(case, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w") as file:
            file.write(text)
    run("blockMesh", case)
    log = run("interFoam", case)
    cpu_time = float(re.findall(r"ExecutionTime = (\S+) s", log)[-1])
    steps = len(re.findall(r"^Time = ", log, re.MULTILINE))

    centres = (numpy.arange(nx) + 0.5) * options.spacing
    for index, instant in enumerate(state_times(flow)):
        depths = read_depths(os.path.join(case, f"{instant:.8g}", "alpha.water"), nx, nz, options.spacing)
        numpy.savetxt(os.path.join(options.out, state_name(index)), numpy.column_stack([centres, depths]),
                      delimiter=",", header="x [m],depth [m]", comments="", fmt="%.9g")
    shutil.rmtree(case)
    write_peer(options.out, options.flow, "OpenFOAM interFoam", f"Courant {options.courant:g}", options.spacing,
               nx * nz, steps, cpu_time)


if __name__ == "__main__":
    main()
