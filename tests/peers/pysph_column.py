#!/usr/bin/python3
"""Runs a plane dam break of `eisph pareto` with PySPH (Debian package python3-pysph).

    tests/peers/pysph_column.py --flow martin_moyce --scheme wcsph --spacing 0.0047625 --out out/peers/wcsph_12

The folder then holds what `eisph pareto --peers` reads. Schemes, kernels, constants and time steps are those of
PySPH's own two-dimensional dam break, at the scale of the flow: sound at ten times sqrt(2 g H), h = 1.3 dx, a time
step of 0.125 h / c, four layers of wall particles without friction. One thread. The CPU time is that of the time
loop: without output, and without what is compiled before.
"""

import argparse
import os
import shutil
import time

import numpy
import pysph
from peer import FLOWS, state_name, state_times, write_peer
from pysph.base.kernels import QuinticSpline, WendlandQuintic
from pysph.base.utils import get_particle_array
from pysph.solver.application import Application
from pysph.solver.utils import iter_output
from pysph.sph.integrator import PECIntegrator
from pysph.sph.scheme import AdamiHuAdamsScheme, WCSPHScheme
from pysph.sph.wc.edac import EDACScheme

GRAVITY = 9.81
DENSITY = 1000.0
WALL_LAYERS = 4

SCHEMES = {"wcsph": "WCSPH", "aha": "Adami", "edac": "EDAC"}


class Column(Application):
    """Water held by the upstream wall and let go at t = 0."""

    def __init__(self, options):
        self.column = options
        self.flow = FLOWS[options.flow]
        self.h = options.smoothing_ratio * options.spacing
        super().__init__(fname="column", output_dir=os.path.join(options.out, "pysph"))

    def create_scheme(self):
        name = self.column.scheme
        sound = 10.0 * numpy.sqrt(2.0 * GRAVITY * self.flow["height"])
        fluids, solids = ["fluid"], ["wall"]
        kernel = QuinticSpline(dim=2)
        step = self.column.courant * self.h / sound
        more = {}
        if name == "wcsph":
            scheme = WCSPHScheme(fluids, solids, dim=2, rho0=DENSITY, c0=sound, h0=self.h,
                                 hdx=self.column.smoothing_ratio, gy=-GRAVITY, alpha=0.1, beta=0.0, gamma=7.0,
                                 hg_correction=True, update_h=True)
            kernel = WendlandQuintic(dim=2)
            more = dict(integrator_cls=PECIntegrator, adaptive_timestep=True, cfl=2.4 * self.column.courant, n_damp=50,
                        fixed_h=False)
        elif name == "aha":
            scheme = AdamiHuAdamsScheme(fluids, solids, dim=2, c0=sound, nu=0.0, rho0=DENSITY, h0=self.h, p0=0.0,
                                        gy=-GRAVITY, gamma=1.0, tdamp=0.0, alpha=0.1)
        else:
            scheme = EDACScheme(fluids, solids, dim=2, c0=sound, nu=0.0, rho0=DENSITY, h=self.h, pb=0.0,
                                gy=-GRAVITY, eps=0.0, clamp_p=True)
        scheme.configure_solver(kernel=kernel, dt=step, tf=self.flow["end"], pfreq=10**9,
                                output_at_times=state_times(self.flow)[1:], **more)
        return scheme

    def create_particles(self):
        dx = self.column.spacing
        common = dict(h=self.h, m=dx * dx * DENSITY, rho=DENSITY)
        columns, layers = round(self.flow["length"] / dx), round(self.flow["height"] / dx)
        i, k = (a.ravel() for a in numpy.meshgrid(numpy.arange(columns), numpy.arange(layers), indexing="ij"))
        fluid = get_particle_array(name="fluid", x=(i + 0.5) * dx, y=(k + 0.5) * dx, **common)
        last = round(self.flow["tank"] / dx)
        i, k = (a.ravel() for a in numpy.meshgrid(numpy.arange(-WALL_LAYERS, last + WALL_LAYERS),
                                                  numpy.arange(-WALL_LAYERS, round(self.flow["tank_height"] / dx)),
                                                  indexing="ij"))
        solid = (i < 0) | (i >= last) | (k < 0)
        wall = get_particle_array(name="wall", x=(i[solid] + 0.5) * dx, y=(k[solid] + 0.5) * dx, **common)
        self.scheme.setup_properties([fluid, wall])
        return [fluid, wall]

    def solve_timed(self):
        """CPU time of the time loop, s."""
        solver = self.solver
        write = solver.dump_output
        writing = 0.0

        def write_untimed(*arguments, **named):
            nonlocal writing
            start = time.process_time()
            write(*arguments, **named)
            writing += time.process_time() - start

        solver.dump_output = write_untimed
        start = time.process_time()
        solver.solve(False)
        return time.process_time() - start - writing


def write_state(path, particles):
    names = ["x [m]", "z [m]", "velocity_x [m/s]", "velocity_z [m/s]", "pressure [Pa]"]
    values = numpy.column_stack([particles.get(name) for name in ("x", "y", "u", "v", "p")])
    numpy.savetxt(path, values, delimiter=",", header=",".join(names), comments="", fmt="%.9g")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--flow", choices=sorted(FLOWS), required=True)
    parser.add_argument("--scheme", choices=sorted(SCHEMES), required=True)
    parser.add_argument("--spacing", type=float, required=True, help="particle spacing, m")
    parser.add_argument("--smoothing-ratio", type=float, default=1.3, help="h / dx")
    parser.add_argument("--courant", type=float, default=0.125,
                        help="time step over h / c; of WCSPH the first one, the others in proportion")
    parser.add_argument("--out", required=True, help="folder of the run")
    options = parser.parse_args()
    os.makedirs(options.out, exist_ok=True)

    app = Column(options)
    app.setup([])
    cpu_time = app.solve_timed()

    # Besides the states asked for there are the first and the last step, which may be the same again.
    times = state_times(app.flow)
    missing = set(range(len(times)))
    for data, fluid in iter_output(app.output_files, "fluid"):
        index = min(range(len(times)), key=lambda k: abs(times[k] - data["t"]))
        if abs(times[index] - data["t"]) < 1e-9:
            write_state(os.path.join(options.out, state_name(index)), fluid)
            missing.discard(index)
    if missing:
        raise SystemExit(f"no state at {times[min(missing)]} s")
    shutil.rmtree(os.path.join(options.out, "pysph"))
    write_peer(options.out, options.flow, f"PySPH {pysph.__version__}, {SCHEMES[options.scheme]}",
               f"Courant {options.courant:g}", options.spacing, fluid.get_number_of_particles(), app.solver.count,
               cpu_time)


if __name__ == "__main__":
    main()
