#!/usr/bin/env python3
"""Draws a part program's path and speed, by gsim's module: plot_wheel.py [PROGRAM [PICTURE]]"""
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

import gsim

program = sys.argv[1] if len(sys.argv) > 1 else "/usr/share/gsim/samples/wheel.nc"
picture = sys.argv[2] if len(sys.argv) > 2 else "wheel.png"

run = gsim.run(program, step_s=0.02)
at, cutting = run.samples, run.moves["process_on"] != 0
print(f"{len(run.moves)} moves, {run.moves['length_mm'][cutting].sum():.1f} mm cut, {run.report['cycle_time_s']:.3f} s")

figure, (path, speed) = plt.subplots(2, figsize=(7, 9), height_ratios=(3, 1))
path.plot(at["axes"][:, 0], at["axes"][:, 1], linewidth=0.8)
path.set(xlabel="X in mm", ylabel="Y in mm", aspect="equal", title=run.report["program"])
speed.plot(at["t_s"], at["speed_mm_s"], linewidth=0.8)
speed.set(xlabel="time in s", ylabel="speed in mm/s")
figure.tight_layout()
figure.savefig(picture)
