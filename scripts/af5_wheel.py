"""Makes a mesh of the thesis's test part: the part of a plate that remains after a jet cuts samples/wheel.path.json, without its kerf."""

import json
import math

THICKNESS = 6.35  # 1/4 in; estimate. At 9.5 mm the inclined walls of a pocket would cross each other
CHORD = 0.05  # mm, max deviation of walls from their arcs
LONGEST_TURN_DEG = 3.0  # max turn of the jet between two vertices of the mesh


def axis(rotary):
    """Returns the direction from the TCP up the tool: tilted by C, then turned by B about the vertical (af5.toml)."""
    turn, tilt = math.radians(rotary["B"]), math.radians(rotary["C"])
    return math.sin(tilt) * math.cos(turn), math.sin(tilt) * math.sin(turn), math.cos(tilt)


def nearest_values(start, end):
    """Returns rotary values that are equivalent to those of an end and nearest to a start: the wheel's program turns B by
    needless full turns, which would cut the part up."""
    turn, tilt = end["B"], end["C"]
    if start["C"] * tilt < 0:
        turn, tilt = turn + 180, -tilt
    return {"B": start["B"] + math.remainder(turn - start["B"], 360), "C": tilt}


def arc(a, via, b):
    """Returns centre and sweep of the arc from a over via to b, in the plane."""
    ax, ay, bx, by = via[0] - a[0], via[1] - a[1], b[0] - a[0], b[1] - a[1]
    cross = 2 * (ax * by - ay * bx)
    x = a[0] + (by * (ax * ax + ay * ay) - ay * (bx * bx + by * by)) / cross
    y = a[1] + (ax * (bx * bx + by * by) - bx * (ax * ax + ay * ay)) / cross
    sweep = (math.atan2(b[1] - y, b[0] - x) - math.atan2(a[1] - y, a[0] - x)) % (2 * math.pi)
    return (x, y), sweep if cross > 0 else sweep - 2 * math.pi


def between(start, end):
    """Returns points of the path from one target to the next, without the first one, each with the direction of the tool."""
    a, b = start["position_mm"], end["position_mm"]
    first, last = start["rotary_deg"], nearest_values(start["rotary_deg"], end["rotary_deg"])
    leans = first["C"] or last["C"]
    steps = math.ceil(max(abs(last[letter] - first[letter]) for letter in "BC") / LONGEST_TURN_DEG) if leans else 1
    centre = None
    if end["motion"] == "circular":
        centre, sweep = arc(a, end["via_mm"], b)
        radius = math.dist(a[:2], centre)
        begin = math.atan2(a[1] - centre[1], a[0] - centre[0])
        steps = max(steps, math.ceil(abs(sweep) / (2 * math.acos(1 - CHORD / radius))))
    for share in (step / max(1, steps) for step in range(1, max(1, steps) + 1)):
        rotary = {letter: first[letter] + share * (last[letter] - first[letter]) for letter in "BC"}
        if centre:
            angle = begin + share * sweep
            place = centre[0] + radius * math.cos(angle), centre[1] + radius * math.sin(angle)
        else:
            place = tuple(a[i] + share * (b[i] - a[i]) for i in (0, 1))
        yield place, axis(rotary)


def contours(path_file):
    """Returns the upper and the lower contour of each closed cut, as lists of points."""
    with open(path_file, encoding="utf-8") as file:
        paths = {path["name"]: path["targets"] for path in json.load(file)["paths"]}
    for name in ("rim", "pockets", "bore"):
        for target in paths[name]:
            if "waterjet_on" in target.get("actions", []):
                cut = []
            else:
                cut.extend(between(last, target))
            last = target
            if "waterjet_off" in target.get("actions", []):
                while crossings([[place for place, _ in cut]]):
                    cut.pop()  # circles are cut a little more than a full turn
                upper = [place for place, _ in cut]
                lower = [(x - THICKNESS * tx / tz, y - THICKNESS * ty / tz) for (x, y), (tx, ty, tz) in cut]
                yield upper, lower


def cross(o, a, b):
    return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0])


def area(points):
    return sum(p[0] * q[1] - p[1] * q[0] for p, q in zip(points, points[1:] + points[:1])) / 2


def crossings(loops):
    """Returns edges of all contours that cross each other: there must be none."""
    edges = [(p, q) for loop in loops for p, q in zip(loop, loop[1:] + loop[:1])]
    return [(e, f) for i, e in enumerate(edges) for f in edges[:i]
            if cross(*e, f[0]) * cross(*e, f[1]) < 0 and cross(*f, e[0]) * cross(*f, e[1]) < 0]


def joined(outside, holes, points):
    """Returns one loop of indices. A bridge from its rightmost point joins each hole to the loop, the rightmost hole first."""
    loop = list(outside)
    for hole in sorted(holes, key=lambda one: -max(points[i][0] for i in one)):
        start = max(range(len(hole)), key=lambda i: points[hole[i]][0])
        hole = hole[start:] + hole[:start]
        tip = points[hole[0]]
        edges = list(zip(loop, loop[1:] + loop[:1]))

        def sees(at):
            end = points[loop[at]]
            before, after = points[loop[at - 1]], points[loop[(at + 1) % len(loop)]]
            inside = cross(end, after, tip) > 0 and cross(end, tip, before) > 0
            if cross(before, end, after) < 0:
                inside = not (cross(end, before, tip) > 0 and cross(end, tip, after) > 0)
            return inside and not any(cross(tip, end, points[p]) * cross(tip, end, points[q]) < 0
                                      and cross(points[p], points[q], tip) * cross(points[p], points[q], end) < 0 for p, q in edges)

        at = min((i for i in range(len(loop)) if points[loop[i]][0] > tip[0] and sees(i)), key=lambda i: math.dist(tip, points[loop[i]]))
        loop[at + 1 : at + 1] = hole + [hole[0], loop[at]]
    return loop


def triangles(loop, points):
    """Returns counterclockwise triangles of the area in a loop, by ear clipping."""
    loop = list(loop)
    while len(loop) > 3:
        for i in range(len(loop)):
            ear = loop[i - 1], loop[i], loop[(i + 1) % len(loop)]
            a, b, c = (points[j] for j in ear)
            if cross(a, b, c) <= 1e-9:
                continue
            if any(cross(a, b, points[j]) > 0 and cross(b, c, points[j]) > 0 and cross(c, a, points[j]) > 0 for j in loop if j not in ear):
                continue
            yield ear
            del loop[i]
            break
        else:
            raise ValueError("no ear: the contour crosses itself")
    yield tuple(loop)


def mesh(path_file, centre):
    """Returns the wheel as a Wavefront OBJ file, with its origin at the centre of its upper side."""
    loops = list(contours(path_file))
    if any(crossings([loop[side] for loop in loops]) for side in (0, 1)):
        raise ValueError("walls cross each other within the thickness")
    points, faces, rings = [], [], []
    for number, (upper, lower) in enumerate(loops):
        if (area(upper) > 0) != (number == 0):
            upper, lower = upper[::-1], lower[::-1]
        count, first = len(upper), len(points)
        points += upper + lower
        rings.append(list(range(first, first + count)))
        for i in range(count):
            a, b = first + i, first + (i + 1) % count
            faces += [(a, a + count, b), (b, a + count, b + count)]
    heights = [0.0] * len(points)
    for ring in rings:
        for i in ring:
            heights[i + len(ring)] = -THICKNESS
    faces += triangles(joined(rings[0], rings[1:], points), points)
    under = [[i + len(ring) for i in ring] for ring in rings]
    faces += [face[::-1] for face in triangles(joined(under[0], under[1:], points), points)]
    lines = ["# The thesis's test part; written by scripts/af5_bodies.py. mm, the origin in the middle of the upper side."]
    lines += [f"v {x - centre[0]:.3f} {y - centre[1]:.3f} {z:.3f}" for (x, y), z in zip(points, heights)]
    lines += [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in faces]
    return "\n".join(lines) + "\n"
