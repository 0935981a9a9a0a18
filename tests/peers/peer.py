"""What the peers share: the flows, and the folder that `eisph pareto --peers` reads."""

import os

# Reservoir and tank, m; end and interval of the states, s. Those of the scenes of the same names; the tank of
# martin_moyce ends where no water arrives in time.
FLOWS = {
    "ritter_long": dict(length=1.5, height=0.1, tank=3.3, tank_height=0.2, end=0.8, interval=0.8),
    "martin_moyce": dict(length=0.05715, height=0.1143, tank=0.4, tank_height=0.2, end=0.24, interval=0.0025),
}


def state_times(flow):
    """Times of the states, s, that at the start included."""
    return [k * flow["interval"] for k in range(round(flow["end"] / flow["interval"]) + 1)]


def state_name(index):
    return f"state_{index:04d}.csv"


def write_peer(folder, flow_name, scheme, setting, spacing, particles, steps, cpu_time):
    """Writes peer.toml beside the tables of the states, of which there is one for every time."""
    lines = [f'case = "{flow_name}"', f'scheme = "{scheme}"', f'setting = "{setting}"', f"spacing = {spacing!r}  # m",
             f"particles = {particles}", f"steps = {steps}", f"cpu_time = {cpu_time:.6g}  # s"]
    for index, instant in enumerate(state_times(FLOWS[flow_name])):
        lines += ["", "[[state]]", f"time = {instant!r}  # s", f'file = "{state_name(index)}"']
    with open(os.path.join(folder, "peer.toml"), "w") as out:
        out.write("\n".join(lines) + "\n")
    print(f"{flow_name}, {scheme}, {setting}, {spacing:g} m: {steps} steps, {cpu_time:.2f} s of CPU time")
