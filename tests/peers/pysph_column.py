#!/usr/bin/python3
"""Runs a plane dam break of `eisph pareto` with PySPH (Debian package python3-pysph).

    tests/peers/pysph_column.py --flow martin_moyce --scheme wcsph --spacing 0.0047625 --out out/peers/wcsph_12

The folder then holds what `eisph pareto --peers` reads. Schemes, kernels, constants and time steps are those of
PySPH's own two-dimensional dam break, at the scale of the flow: sound at ten times sqrt(2 g H), four layers of wall
particles without friction. One thread. The CPU time is that of the time loop: without output, and without what is
compiled before.
"""

import argparse
import os
import shutil
import time

import numpy
import pysph
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

# Reservoir and tank, m; end and interval of the states, s. Those of the scenes of the same names.
FLOWS = {
    "ritter_long": dict(length=1.5, height=0.1, tank=3.3, tank_height=0.2, end=0.8, interval=0.8),
    "martin_moyce": dict(length=0.05715, height=0.1143, tank=0.4, tank_height=0.2, end=0.24, interval=0.0025),
}
SCHEMES = {"wcsph": "WCSPH", "aha": "Adami", "edac": "EDAC"}


class Column(Application):
    """Water held by the upstream wall and let go at t = 0."""

    def __init__(self, options):
        self.column = options
        self.flow = FLOWS[options.flow]
        self.h = options.smoothing_ratio * options.spacing
        count = round(self.flow["end"] / self.flow["interval"])
        self.times = [k * self.flow["interval"] for k in range(1, count + 1)]
        super().__init__(fname="column", output_dir=os.path.join(options.out, "pysph"))

    def create_scheme(self):
        name = self.column.scheme
        sound = 10.0 * numpy.sqrt(2.0 * GRAVITY * self.flow["height"])
        fluids, solids = ["fluid"], ["wall"]
        kernel = QuinticSpline(dim=2)
        step = 0.125 * self.h / sound
        more = {}
        if name == "wcsph":
            scheme = WCSPHScheme(fluids, solids, dim=2, rho0=DENSITY, c0=sound, h0=self.h,
                                 hdx=self.column.smoothing_ratio, gy=-GRAVITY, alpha=0.1, beta=0.0, gamma=7.0,
                                 hg_correction=True, update_h=True)
            kernel = WendlandQuintic(dim=2)
            more = dict(integrator_cls=PECIntegrator, adaptive_timestep=True, n_damp=50, fixed_h=False)
        elif name == "aha":
            scheme = AdamiHuAdamsScheme(fluids, solids, dim=2, c0=sound, nu=0.0, rho0=DENSITY, h0=self.h, p0=0.0,
                                        gy=-GRAVITY, gamma=1.0, tdamp=0.0, alpha=0.1)
        else:
            scheme = EDACScheme(fluids, solids, dim=2, c0=sound, nu=0.0, rho0=DENSITY, h=self.h, pb=0.0,
                                gy=-GRAVITY, eps=0.0, clamp_p=True)
        scheme.configure_solver(kernel=kernel, dt=step, tf=self.flow["end"], pfreq=10**9,
                                output_at_times=self.times, **more)
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
    parser.add_argument("--out", required=True, help="folder of the run")
    options = parser.parse_args()
    os.makedirs(options.out, exist_ok=True)

    app = Column(options)
    app.setup([])
    cpu_time = app.solve_timed()

    states = []
    wanted = [0.0] + app.times
    for data, fluid in iter_output(app.output_files, "fluid"):
        nearest = min(wanted, key=lambda t: abs(t - data["t"]))
        if abs(nearest - data["t"]) > 1e-9 or any(t == nearest for t, _ in states):
            continue
        name = f"state_{len(states):04d}.csv"
        write_state(os.path.join(options.out, name), fluid)
        states.append((nearest, name))
    shutil.rmtree(os.path.join(options.out, "pysph"))

    with open(os.path.join(options.out, "peer.toml"), "w") as out:
        out.write(f'case = "{options.flow}"\nscheme = "PySPH {pysph.__version__}, {SCHEMES[options.scheme]}"\n')
        out.write(f'setting = "h = {options.smoothing_ratio:g} dx"\nspacing = {options.spacing!r}  # m\n')
        out.write(f"steps = {app.solver.count}\ncpu_time = {cpu_time:.6g}  # s\n")
        for instant, name in states:
            out.write(f'\n[[state]]\ntime = {instant!r}  # s\nfile = "{name}"\n')
    print(f"{options.flow}, {options.scheme}: {app.solver.count} steps, {cpu_time:.2f} s, {len(states)} states")


if __name__ == "__main__":
    main()
