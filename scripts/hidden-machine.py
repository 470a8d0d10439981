#!/usr/bin/env python3
"""Makes recordings to test gsim-calibrate: part programs, a machine with hidden parameters, and the times that it takes for them, with
noise and a coarse clock, as a shop would note them.
Usage: hidden-machine.py GSIM FOLDER [SEED]
In FOLDER: programs/*.ngc, runs.csv (program,time_s), start.toml (the machine as it is known: speeds and ranges, guesses for all others),
and hidden.toml, for the comparison afterwards."""

import json
import math
import random
import subprocess
import sys
from pathlib import Path

CLOCK_S = 0.05
NOISE = 0.002  # of a time, one standard deviation

AXES = "".join(f"""
[[axis]]
letter = "{letter}"
kind = "linear"
min_mm = {low}
max_mm = {high}
max_speed_mm_s = 120.0
max_acceleration_mm_s2 = {{acceleration}}
direction = "{letter.lower()}"
""" for letter, low, high in (("X", -50.0, 400.0), ("Y", -50.0, 300.0), ("Z", -80.0, 100.0)))


def machine(name, acceleration, rules):
    """Returns a machine file of three axes."""
    head = f'[machine]\nname = "{name}"\ninverse = "gantry"\n\n[controller]\n{rules}\n\n[process]\nkind = "spindle"\non = ["M3"]\noff = ["M5"]\n'
    return head + AXES.format(acceleration=acceleration)


def pocket(rng):
    """Straight passes, back and forth."""
    feed, width, step = rng.choice([1500, 3000, 5000]), rng.uniform(40, 150), rng.uniform(2, 6)
    lines = ["G0 X0 Y0 Z5", "G1 Z-2 F600"]
    for row in range(rng.randint(6, 14)):
        lines += [f"G1 X{width if row % 2 == 0 else 0:.3f} F{feed}", f"G1 Y{(row + 1) * step:.3f}"]
    return lines


def curve(rng):
    """A freeform curve of short lines."""
    feed, lines = rng.choice([2000, 4000, 6000]), ["G0 X0 Y100 Z5", "G1 Z-1 F600"]
    waves, height = rng.uniform(1, 4), rng.uniform(10, 40)
    for i in range(1, 161):
        x = i * 1.5
        lines.append(f"G1 X{x:.3f} Y{100 + height * math.sin(waves * x / 40):.3f} F{feed}")
    return lines


def holes(rng):
    """A grid of holes."""
    lines = ["G0 X0 Y0 Z5"]
    for i in range(rng.randint(6, 16)):
        lines += [f"G0 X{(i % 4) * rng.uniform(10, 40):.3f} Y{i // 4 * rng.uniform(10, 40):.3f}", f"G1 Z-{rng.uniform(2, 8):.3f} F400", "G0 Z5"]
    return lines


def slots(rng):
    """Contours of lines and arcs."""
    feed, lines = rng.choice([1200, 2500, 4500]), ["G0 X20 Y20 Z5"]
    for i in range(rng.randint(3, 7)):
        radius, length = rng.uniform(3, 15), rng.uniform(20, 80)
        y = 20 + 30 * i
        lines += [f"G0 X20 Y{y:.3f}", "G1 Z-2 F500", f"G1 X{20 + length:.3f} F{feed}",
                  f"G3 X{20 + length:.3f} Y{y + 2 * radius:.3f} I0 J{radius:.3f}", f"G1 X20", f"G3 X20 Y{y:.3f} I0 J-{radius:.3f}", "G0 Z5"]
    return lines


def recorded_s(gsim, program, machine_file, rng):
    """Returns the time of the hidden machine, as its operator notes it."""
    ran = subprocess.run([gsim, "run", "--dialect", "rs274ngc", "--machine", machine_file, "--json", program], capture_output=True, text=True, check=True)
    time_s = json.loads(ran.stdout)["cycle_time_s"] * rng.gauss(1, NOISE)
    return round(time_s / CLOCK_S) * CLOCK_S


def main():
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    gsim, folder = sys.argv[1], Path(sys.argv[2])
    rng = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 1)
    (folder / "programs").mkdir(parents=True, exist_ok=True)
    acceleration, step_s = rng.uniform(250, 1500), rng.uniform(0.003, 0.03)
    hidden = folder / "hidden.toml"
    hidden.write_text(machine("router with hidden figures", f"{acceleration:.3f}", "\n".join(
        ('planner = "look-ahead"', 'look_ahead_blocks = 200', 'corner = "velocity-step"', 'exact_path_corner = "velocity-step"', f'speed_step_s = {step_s:.5f}',
         'stop_between_rapid_and_feed = false', f'centripetal_share = {rng.uniform(0.5, 0.95):.4f}'))), encoding="utf-8")
    (folder / "start.toml").write_text(machine("router", "500.0", 'model = "exact-stop"'), encoding="utf-8")
    rows = ["program,time_s"]
    for number in range(1, 17):
        kind = (pocket, curve, holes, slots)[number % 4]
        program = folder / "programs" / f"{kind.__name__}-{number:02}.ngc"
        program.write_text("\n".join(["G21 G90 G94 G17 G64", "M3 S1000", *kind(rng), "G0 Z50", "M2", ""]), encoding="utf-8")
        rows.append(f"programs/{program.name},{recorded_s(gsim, program, hidden, rng):.2f}")
    (folder / "runs.csv").write_text("\n".join(rows) + "\n", encoding="utf-8")
    print(f"{len(rows) - 1} recorded runs in {folder}/runs.csv")


main()
