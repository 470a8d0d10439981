#!/usr/bin/env python3
"""Writes the bodies of the AF-series gantry as [[shape]] tables of its machine files, and the mesh of its test part.

Usage: af5_bodies.py          writes them into samples/machines/af5*.toml and samples/cell/wheel.obj
       af5_bodies.py --check  fails if the files differ from them

Strokes, ranges and the construction of the machine are those of the thesis's Table C.1 and Figure C.1: a free-standing gantry with
its axes between its legs and above the work, and the TCP at the point where both rotary axes meet. The thesis does not give sizes of
bodies: those marked 'estimate' are ours, with clearance for all strokes. The TCP does not move while the head tilts, and nothing is at
its height, so there must be a guide about the TCP: an arc on which the head moves.
"""

import math
import sys
from pathlib import Path

import af5_wheel


SAMPLES = Path(__file__).resolve().parent.parent / "samples"
MARK = "# Bodies, written by scripts/af5_bodies.py.\n"

# Table C.1, in mm.
STROKE_X, STROKE_Y, STROKE_Z = 1828.8, 2438.4, 609.6
CENTRE_X, CENTRE_Y = STROKE_X / 2, STROKE_Y / 2

# The head, from the TCP up along the tool's axis. The tube is the usual one of abrasive heads, 0.281 by 3 in. Its end is
# ground to a point, 6 mm off the work, so that it does not touch a plate at the 71 degrees of the test part.
STAND_OFF, POINT_END, TUBE_END = 6.0, 14.0, 90.2
GUARD_AT, HEAD_END, VALVE_END, CARRIAGE_END = 75.0, 180.0, 290.0, 340.0  # estimates
JET_END = -60.0  # the water of the catcher stops the jet at this height; estimate

# The guide of the tilt axis, an arc about the TCP, and the bodies that carry it. Estimates.
GUIDE_RADIUS, GUIDE_DEPTH, GUIDE_WIDTH, GUIDE_HALF_DEG, GUIDE_PARTS = 370.0, 50.0, 80.0, 70.0, 5
TURNTABLE_FROM, TURNTABLE_TO = 395.0, 545.0
RAM_TO = 1545.0

# The gantry, from the TCP with all axes at 0. Estimates with clearance for all strokes.
BRIDGE_FROM, BRIDGE_TO = 1240.0, 1560.0
LEGS_BEYOND = 700.0
FLOOR, TANK_FROM, TANK_TO = -1000.0, -650.0, -150.0


def box(name, on, size, place, source):
    return name, on, f"box_mm = [{', '.join(f'{value:.1f}' for value in size)}]", place, source


def cylinder(name, on, diameter, height, place, source):
    return name, on, f"cylinder_mm = [{diameter:.2f}, {height:.1f}]", place, source


def base_box(name, size, centre, source):
    """Returns a box on the base, whose frame has its X up, its Y opposite to the world's Y, its Z along the world's X."""
    return box(name, "base", (size[2], size[1], size[0]), {"x_mm": centre[2], "y_mm": -centre[1], "z_mm": centre[0]}, source)


def bridge_box(name, size, centre, source):
    """Returns a box on the bridge, whose frame has its X up, its Y along the world's X, its Z along the world's Y."""
    return box(name, "X", (size[2], size[0], size[1]), {"x_mm": centre[2], "y_mm": centre[0], "z_mm": centre[1]}, source)


def base():
    yield base_box("tank", (STROKE_X + 300, STROKE_Y + 300, TANK_TO - TANK_FROM), (CENTRE_X, CENTRE_Y, (TANK_FROM + TANK_TO) / 2),
                   "the catcher: the strokes plus 150 mm on each side; estimate")
    for side, y in (("left", -LEGS_BEYOND), ("right", STROKE_Y + LEGS_BEYOND)):
        yield base_box(f"{side} rail", (STROKE_X + 1200, 200, 200), (CENTRE_X, y, BRIDGE_FROM - 100), "estimate")
        for end, x in (("front", -500.0), ("rear", STROKE_X + 500)):
            height = BRIDGE_FROM - 200 - FLOOR
            yield base_box(f"{side} {end} leg", (200, 200, height), (x, y, FLOOR + height / 2), "estimate")


def axes(turn, tilt):
    height = BRIDGE_TO - BRIDGE_FROM
    middle = (BRIDGE_FROM + BRIDGE_TO) / 2
    yield bridge_box("bridge", (250, STROKE_Y + 2 * LEGS_BEYOND + 200, height), (-350, CENTRE_Y, middle), "estimate")
    yield box("carriage", "Y", (375, 400, height), {"x_mm": -37.5, "z_mm": middle}, "estimate")
    yield box("ram", "Z", (160, 160, RAM_TO - TURNTABLE_TO), {"z_mm": (TURNTABLE_TO + RAM_TO) / 2},
              "as long as its stroke plus the carriage's height; estimate")
    # In the frame after the rotary axis about the vertical, Y points down and Z along the axis of the tilt.
    yield cylinder("turntable", turn, 220, TURNTABLE_TO - TURNTABLE_FROM,
                   {"y_mm": -(TURNTABLE_FROM + TURNTABLE_TO) / 2, "yaw_deg": 90.0}, "estimate")
    part = 2 * GUIDE_HALF_DEG / GUIDE_PARTS
    chord = 2 * (GUIDE_RADIUS + GUIDE_DEPTH / 2) * math.tan(math.radians(part / 2))
    for index in range(GUIDE_PARTS):
        angle = part * (index - (GUIDE_PARTS - 1) / 2)
        yield box(f"guide {index + 1}", turn, (chord, GUIDE_DEPTH, GUIDE_WIDTH),
                  {"x_mm": GUIDE_RADIUS * math.sin(math.radians(angle)),
                   "y_mm": -GUIDE_RADIUS * math.cos(math.radians(angle)), "roll_deg": angle},
                  "a fifth of the arc on which the head tilts; estimate")
    # In the frame after the tilt, Z points along the tool.
    yield box("tilt carriage", tilt, (120, 90, CARRIAGE_END - VALVE_END), {"z_mm": (VALVE_END + CARRIAGE_END) / 2}, "estimate")


def tool():
    def part(name, diameter, low, high, source):
        return cylinder(name, "tool", diameter, high - low, {"z_mm": (low + high) / 2}, source)

    yield part("valve", 60, HEAD_END, VALVE_END, "pneumatic, on and off; estimate")
    yield part("head", 45, TUBE_END, HEAD_END, "PASER3: orifice and mixing chamber; estimate")
    yield cylinder("abrasive inlet", "tool", 12, 60, {"y_mm": 50.0, "z_mm": 105.0, "yaw_deg": 90.0}, "to the side of the tilt; estimate")
    yield part("guard", 40, GUARD_AT - 5, GUARD_AT + 5, "against splashes; estimate")
    yield part("nozzle", 7.14, POINT_END, TUBE_END, "mixing tube, 0.281 by 3 in")
    yield part("nozzle end", 3, STAND_OFF, POINT_END, "its end, ground to a point; estimate")
    yield cylinder("jet", "jet", 1, STAND_OFF - JET_END, {"z_mm": (STAND_OFF + JET_END) / 2}, "kerf 1 mm; its depth in the water is an estimate")


def table(name, on, form, place, source):
    frame = ", ".join(f"{key} = {round(float(value), 3)}" for key, value in place.items() if abs(value) > 5e-4)
    lines = ["", "[[shape]]", f'name = "{name}"  # {source}', f'on = "{on}"', f"shape = {{ {form} }}"]
    return "\n".join(lines + ([f"frame = {{ {frame} }}"] if frame else [])) + "\n"


def bodies(turn, tilt):
    return "".join(table(*shape) for group in (base(), axes(turn, tilt), tool()) for shape in group)


# The letters of the axis about the vertical and of the tilt axis.
MACHINES = {"af5.toml": "BC", "af5-measured.toml": "BC", "af5-table-letters.toml": "CB"}
WHEEL = (500, 500)


def main():
    check = sys.argv[1:] == ["--check"]
    if sys.argv[1:] and not check:
        sys.exit(__doc__)
    files = {SAMPLES / "cell" / "wheel.obj": af5_wheel.mesh(SAMPLES / "wheel.path.json", WHEEL)}
    for name, letters in MACHINES.items():
        path = SAMPLES / "machines" / name
        files[path] = path.read_text(encoding="utf-8").split(MARK)[0].rstrip("\n") + "\n\n" + MARK + bodies(*letters)
    differing = [str(path) for path, text in files.items() if not path.exists() or path.read_text(encoding="utf-8") != text]
    if not check:
        for path, text in files.items():
            path.write_text(text, encoding="utf-8")
    if check and differing:
        sys.exit("not what scripts/af5_bodies.py writes: " + ", ".join(differing))


if __name__ == "__main__":
    main()
