-- Plane geometry of cutter compensation, without any state. A point or vector is {u, v} on the two axes of
-- the
-- plane. `side` is 1 if the tool runs on the left of the path and -1 on the right.
--
-- A segment is one programmed move:
--   { from, to, heading = {direction at the start, direction at the end} }            a line
--   the same with centre, turn (1 counterclockwise, -1 clockwise), radius, sweep      an arc
-- `radius` is the one at the end of the arc; a program may define arcs with slightly different radii.

local TURN = 2 * math.pi
local SAME_ANGLE = 1e-6
local CLOSED_RAD = 0.001   -- between the ends of what is a full circle
local CLOSED_MM = 0.001    -- between ends that count as one point

local g = {}

function g.plus(p, vector, factor) return { p[1] + vector[1] * factor, p[2] + vector[2] * factor } end
function g.minus(p, q) return { p[1] - q[1], p[2] - q[2] } end
function g.dot(a, b) return a[1] * b[1] + a[2] * b[2] end
function g.cross(a, b) return a[1] * b[2] - a[2] * b[1] end
function g.length(a) return math.sqrt(a[1] * a[1] + a[2] * a[2]) end
function g.distance(p, q) return g.length(g.minus(p, q)) end

function g.unit(vector)
  local size = g.length(vector)
  return { vector[1] / size, vector[2] / size }
end

-- Returns the vector turned by a quarter to the left, or to the right if side is -1.
function g.normal(direction, side) return { -direction[2] * side, direction[1] * side } end

function g.line(from, to)
  local direction = g.unit(g.minus(to, from))
  return { from = from, to = to, heading = { direction, direction } }
end

function g.arc(from, to, centre, ccw, sweep)
  local turn = ccw and 1 or -1
  local function heading(p) return g.normal(g.unit(g.minus(p, centre)), turn) end
  return {
    from = from, to = to, heading = { heading(from), heading(to) },
    centre = centre, turn = turn, radius = g.distance(to, centre), sweep = sweep,
  }
end

-- Return the position of the tool next to the start and the end of a segment: at right angles, at that
-- distance.
function g.offset_start(segment, side, distance)
  return g.plus(segment.from, g.normal(segment.heading[1], side), distance)
end
function g.offset_end(segment, side, distance)
  return g.plus(segment.to, g.normal(segment.heading[2], side), distance)
end

-- Returns true if the tool runs on the same side of an arc as its centre.
function g.tool_inside(segment, side) return segment.turn == side end

-- Returns the radius of the path of the tool along an arc; not above 0 if the tool does not fit.
function g.tool_radius(segment, side, distance) return segment.radius - segment.turn * side * distance end

-- Returns the angle from one direction to another, above -pi and up to pi, above 0 to the left.
function g.angle(a, b) return math.atan(g.cross(a, b), g.dot(a, b)) end

-- Returns the angle from one point to another about a centre in the sense of travel: above 0, up to a full
-- turn.
function g.sweep_angle(from, to, centre, turn)
  local angle = (turn * g.angle(g.minus(from, centre), g.minus(to, centre))) % TURN
  return angle > 0 and angle or TURN
end

-- Returns the angle swept along an arc after its ends were moved or cut back. `programmed` gives the number
-- of full turns. It also distinguishes a circle that is nearly closed from an arc that has nearly no length.
function g.swept_after(from, to, centre, turn, programmed)
  local full_turns = math.ceil((programmed - SAME_ANGLE) / TURN) - 1
  local angle = g.sweep_angle(from, to, centre, turn) + full_turns * TURN
  if angle + TURN < programmed + CLOSED_RAD then angle = angle + TURN end
  local most = (full_turns + 1) * TURN
  return math.abs(angle - most) * g.distance(from, centre) < CLOSED_MM and most or angle
end

-- Two curves have one or two intersection points. The tool's path continues at the one at which it turns to
-- the side of the tool, because there it has reached both.

local function intersect_lines(p, q, side, distance)
  local a, b = g.offset_end(p, side, distance), g.offset_start(q, side, distance)
  local d, e = p.heading[2], q.heading[1]
  local sine = g.cross(d, e)
  if sine == 0 then return nil end
  return g.plus(a, d, g.cross(g.minus(b, a), e) / sine)
end

-- Returns a point on a line of this direction at this height to its left of the centre; ahead: the point
-- where it leaves the circle.
local function line_circle_point(centre, radius, direction, height, ahead)
  if math.abs(height) > radius then return nil end
  local along = math.sqrt(radius * radius - height * height)
  local foot = g.plus(centre, g.normal(direction, 1), height)
  return g.plus(foot, direction, ahead and along or -along)
end

-- Returns the height of the tool's path along a line above the centre of an arc; the corner is moved to the
-- circle of `radius`.
local function height_above(arc, corner, direction, side, distance)
  local spoke = g.unit(g.minus(corner, arc.centre))
  return g.cross(direction, spoke) * arc.radius + side * distance
end

local function intersect_line_arc(p, q, side, distance)
  local direction = p.heading[2]
  return line_circle_point(q.centre, g.tool_radius(q, side, distance), direction,
    height_above(q, q.from, direction, side, distance), g.tool_inside(q, side))
end

local function intersect_arc_line(p, q, side, distance)
  local direction = q.heading[1]
  return line_circle_point(p.centre, g.tool_radius(p, side, distance), direction,
    height_above(p, p.to, direction, side, distance), not g.tool_inside(p, side))
end

-- Returns the intersection of two circles: the foot on the line of centres, its direction, and the distance
-- of the points from that line.
local function circle_intersection(a, r1, b, r2)
  local apart = g.distance(a, b)
  if apart == 0 or r1 == 0 then return nil end
  local cosine = (r1 * r1 + apart * apart - r2 * r2) / (2 * r1 * apart)
  if math.abs(cosine) > 1 then return nil end
  local axis = g.unit(g.minus(b, a))
  return g.plus(a, axis, r1 * cosine), axis, r1 * math.sqrt(1 - cosine * cosine)
end

local function intersect_arcs(p, q, side, distance)
  local foot, axis, beside = circle_intersection(p.centre, g.tool_radius(p, side, distance), q.centre,
    g.tool_radius(q, side, distance))
  return foot and g.plus(foot, g.normal(axis, p.turn * q.turn * side), beside)
end

-- Returns the point of an inside corner at which the tool passes from segment p to q, or nil if it does not
-- fit in.
function g.intersect(p, q, side, distance)
  if p.centre and q.centre then return intersect_arcs(p, q, side, distance) end
  if p.centre then return intersect_arc_line(p, q, side, distance) end
  if q.centre then return intersect_line_arc(p, q, side, distance) end
  return intersect_lines(p, q, side, distance)
end

local function arc_line_crossings(arc, arc_side, arc_distance, line, line_side, line_distance)
  local direction = line.heading[1]
  local height = g.cross(direction, g.minus(g.offset_start(line, line_side, line_distance), arc.centre))
  local radius = g.tool_radius(arc, arc_side, arc_distance)
  return {
    line_circle_point(arc.centre, radius, direction, height, false),
    line_circle_point(arc.centre, radius, direction, height, true),
  }
end

-- Returns the common points, zero or two, of the tool's paths along two segments, of which one or both are
-- arcs.
function g.crossings(p, p_side, p_distance, q, q_side, q_distance)
  if not q.centre then return arc_line_crossings(p, p_side, p_distance, q, q_side, q_distance) end
  if not p.centre then return arc_line_crossings(q, q_side, q_distance, p, p_side, p_distance) end
  local foot, axis, beside = circle_intersection(p.centre, g.tool_radius(p, p_side, p_distance), q.centre,
    g.tool_radius(q, q_side, q_distance))
  return foot and { g.plus(foot, g.normal(axis, 1), beside), g.plus(foot, g.normal(axis, -1), beside) } or {}
end

-- Returns true if a point of the segment's line or circle, or next to it, lies between its ends.
function g.within_arc(arc, point)
  return g.sweep_angle(arc.from, point, arc.centre, arc.turn) <= arc.sweep
end

function g.within_line(line, point)
  local along = g.dot(g.minus(point, line.from), line.heading[1])
  return along >= 0 and along <= g.distance(line.from, line.to)
end

-- Returns the curvature to the left: 0 for a line.
function g.curvature(segment) return segment.centre and segment.turn / segment.radius or 0 end

return g
