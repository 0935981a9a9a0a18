"""What the OpenFOAM peers share: how its programs are run, and what every case of interFoam has in common.

Volume of fluid with air above, walls without friction, no turbulence model; schemes and solvers as is usual for such
flows. Debian's package openfoam.
"""

import os
import re
import subprocess
import sys

BASHRC = "/usr/share/openfoam/etc/bashrc"


def header(kind, name, form="ascii"):
    return f"FoamFile {{ version 2.0; format {form}; class {kind}; object {name}; }}\n"


def run(command, folder):
    """Output of an OpenFOAM program; ends this one if it fails."""
    line = f"source {BASHRC} >/dev/null 2>&1; exec {command}"
    done = subprocess.run(["bash", "-c", line], cwd=folder, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{command} failed in {folder}:\n{(done.stdout + done.stderr)[-2000:]}")
    return done.stdout


def write_files(folder, files):
    """Writes the texts of `files`, by path, below `folder`."""
    for name, text in files.items():
        path = os.path.join(folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w") as file:
            file.write(text)


def cpu_time(log):
    """CPU time of interFoam, s, its start and the states that it writes included."""
    return float(re.findall(r"ExecutionTime = (\S+) s", log)[-1])


def step_count(log):
    return len(re.findall(r"^Time = ", log, re.MULTILINE))


def version(log):
    return re.search(r"OPENFOAM=(\S+)", log).group(1)


def read_scalars(path, cells):
    """The values of a volScalarField in ASCII, a list of `cells` numbers."""
    with open(path) as file:
        text = file.read()
    uniform = re.search(r"internalField\s+uniform\s+(\S+);", text)
    if uniform:
        return [float(uniform.group(1))] * cells
    values = re.search(r"internalField\s+nonuniform[^(]*\(([^)]*)\)", text).group(1)
    return [float(value) for value in values.split()]


def fluids():
    """Water and air, gravity, and no turbulence: files of constant/."""
    return {
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
    }


def schemes():
    return header("dictionary", "fvSchemes") + """
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
"""


def solution(pressure_solver):
    """fvSolution with the given solver of the pressure equation, "solver ...; and what belongs to it;"."""
    return header("dictionary", "fvSolution") + f"""
solvers {{
  "alpha.water.*" {{ nAlphaCorr 2; nAlphaSubCycles 1; cAlpha 1; MULESCorr yes; nLimiterIter 5;
                    solver smoothSolver; smoother symGaussSeidel; tolerance 1e-8; relTol 0; }}
  "pcorr.*" {{ solver PCG; preconditioner DIC; tolerance 1e-5; relTol 0; }}
  p_rgh {{ {pressure_solver} tolerance 1e-7; relTol 0.05; }}
  p_rghFinal {{ $p_rgh; relTol 0; }}
  U {{ solver smoothSolver; smoother symGaussSeidel; tolerance 1e-6; relTol 0; }}
}}
PIMPLE {{ momentumPredictor no; nOuterCorrectors 1; nCorrectors 3; nNonOrthogonalCorrectors 0; }}
relaxationFactors {{ equations {{ ".*" 1; }} }}
"""


def fields(alpha, patches):
    """Files of 0/: still water, alpha.water as given ("uniform 0" or a list), and a function that writes the
    boundary conditions of a field from those of walls and of the open top."""
    return {
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
internalField {alpha};
""" + patches("type zeroGradient;", "type inletOutlet; inletValue uniform 0; value uniform 0;"),
    }
