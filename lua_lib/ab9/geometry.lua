-- Geometry in a plane for chamfers, corner radii and angles of lines. Points are { first, second } in mm. A
-- path part (`element`) has `from` and `to`, and if it is an arc its centre, radius, sense (1
-- counterclockwise, -1 clockwise) and sweep.

local g = use "common/comp_geometry"

local SAME_MM = 1e-6
local STRAIGHT = 1e-9   -- sine of the angle below which two directions are one
local TURN = 2 * math.pi

local minus, plus, length, cross, dot, unit = g.minus, g.plus, g.length, g.cross, g.dot, g.unit
local function left_normal(a) return g.normal(a, 1) end

local function direction_at(element, point)
  if element.centre == nil then return unit(minus(element.to, element.from)) end
  local outward = unit(minus(point, element.centre))
  return { -element.sense * outward[2], element.sense * outward[1] }
end

local function element_length(element)
  if element.centre == nil then return length(minus(element.to, element.from)) end
  return element.radius * element.sweep
end

-- Returns the angle from one point to another as seen from a centre, in the sense of travel, 0 to 2 pi.
local function sweep_between(from, to, centre, sense)
  local a, b = minus(from, centre), minus(to, centre)
  return (sense * math.atan(cross(a, b), dot(a, b))) % TURN
end

local function distance_along(element, point)
  if element.centre == nil then return dot(minus(point, element.from), direction_at(element)) end
  local angle = sweep_between(element.from, point, element.centre, element.sense)
  if TURN - angle < SAME_MM / element.radius then angle = 0 end
  return angle * element.radius
end

-- Returns the distance of a point along the part, from 0 at its start, mm; nil if it is beyond the ends. On
-- an arc of several turns a point has no such distance.
local function along(element, point)
  if element.centre and element.sweep > TURN + STRAIGHT then return nil end
  local reached = distance_along(element, point)
  local on_it = reached >= -SAME_MM and reached <= element_length(element) + SAME_MM
  return on_it and math.max(reached, 0) or nil
end

-- Returns a list of the intersection points of two curves, each a line {from, direction} or a circle {centre,
-- radius}.
local function intersect_lines(a, b)
  local across = cross(a.direction, b.direction)
  if math.abs(across) < STRAIGHT then return {} end
  return { plus(a.from, a.direction, cross(minus(b.from, a.from), b.direction) / across) }
end

local function intersect_line_circle(line, circle)
  local to_centre = minus(circle.centre, line.from)
  local foot = plus(line.from, line.direction, dot(to_centre, line.direction))
  local height = length(minus(circle.centre, foot))
  local half = circle.radius * circle.radius - height * height
  if half < -SAME_MM * circle.radius then return {} end
  half = math.sqrt(math.max(half, 0))
  return { plus(foot, line.direction, half), plus(foot, line.direction, -half) }
end

local function intersect_circles(a, b)
  local between = minus(b.centre, a.centre)
  local distance = length(between)
  if distance < SAME_MM then return {} end
  local reach = (a.radius * a.radius - b.radius * b.radius + distance * distance) / (2 * distance)
  local half = a.radius * a.radius - reach * reach
  if half < -SAME_MM * a.radius then return {} end
  local axis = unit(between)
  local foot = plus(a.centre, axis, reach)
  half = math.sqrt(math.max(half, 0))
  return { plus(foot, left_normal(axis), half), plus(foot, left_normal(axis), -half) }
end

local function intersect(a, b)
  if a.centre and b.centre then return intersect_circles(a, b) end
  if a.centre then return intersect_line_circle(b, a) end
  if b.centre then return intersect_line_circle(a, b) end
  return intersect_lines(a, b)
end

-- Returns the curve at the given distance to the left of a part (to the right: below 0); nil if no curve is
-- left.
local function offset(element, distance)
  if element.centre == nil then
    local direction = direction_at(element)
    return { from = plus(element.from, left_normal(direction), distance), direction = direction }
  end
  local radius = element.radius - element.sense * distance
  return radius > 0 and { centre = element.centre, radius = radius } or nil
end

-- Returns the point of a part that is nearest to a point next to it.
local function foot(element, point)
  if element.centre == nil then
    local direction = direction_at(element)
    return plus(element.from, direction, dot(minus(point, element.from), direction))
  end
  return plus(element.centre, unit(minus(point, element.centre)), element.radius)
end

-- Returns the rounding of radius r between two parts: first tangent point, second one, centre, sense; nil if
-- none fits.
local function rounding(a, b, r, sense)
  local one, two = offset(a, sense * r), offset(b, sense * r)
  if one == nil or two == nil then return nil end
  local best, nearest
  for _, centre in ipairs(intersect(one, two)) do
    local from, to = foot(a, centre), foot(b, centre)
    local distance = length(minus(centre, a.to))
    if along(a, from) and along(b, to) and (nearest == nil or distance < nearest) then
      best, nearest = { from = from, to = to, centre = centre, sense = sense }, distance
    end
  end
  return best
end

-- Returns the point of a part at a distance from the corner, which is at its start or its end.
local function point_at_distance(element, corner, distance, at_start)
  if element.centre == nil then
    local way = direction_at(element)
    return plus(corner, way, at_start and distance or -distance)
  end
  if distance > 2 * element.radius then return nil end
  local angle = element.sense * 2 * math.asin(distance / (2 * element.radius)) * (at_start and 1 or -1)
  local c, s = math.cos(angle), math.sin(angle)
  local from = minus(corner, element.centre)
  return { element.centre[1] + c * from[1] - s * from[2], element.centre[2] + s * from[1] + c * from[2] }
end

local function chamfer(a, b, distance)
  local from, to = point_at_distance(a, a.to, distance, false), point_at_distance(b, b.from, distance, true)
  if from == nil or to == nil or not along(a, from) or not along(b, to) then return nil end
  return { from = from, to = to }
end

return {
  same_mm = SAME_MM, straight = STRAIGHT,
  minus = minus, length = length, cross = cross, dot = dot,
  direction_at = direction_at, element_length = element_length, along = along, intersect = intersect,
  rounding = rounding, chamfer = chamfer, sweep_between = sweep_between,
}
