-- Curves in the XY plane by control points, in the manner of LinuxCNC: four times as many sections as control
-- points, each a pair of arcs that have its ends and its tangents.

local distance_in_space = use("core/basics", "distance_in_space")

local SECTIONS_PER_POINT = 4
local TANGENT_STEP = 1e-5    -- of the parameter: tangents are chords of twice as much
local STRAIGHT_MM2 = 1e-6    -- twice a triangle's area: an arc with less between chord and tangent is a line

local splines = {}

-- A control point with weight is {w x, w y, w z, w}: affine sums of such points are those of the curve.
local function weighted_point(point, weight)
  return { point.x * weight, point.y * weight, point.z * weight, weight }
end

local function interpolated(a, b, part)
  local point = {}
  for i = 1, 4 do point[i] = a[i] + (b[i] - a[i]) * part end
  return point
end

local function cartesian_point(point) return { x = point[1] / point[4], y = point[2] / point[4], z = point[3] / point[4] } end

-- Returns the knots of a NURBS that begins at its first control point and ends at its last, evenly spaced
-- between.
local function uniform_knots(count, order)
  local knots = {}
  for i = 1, count + order do knots[i] = math.max(0, math.min(i - order, count - order + 1)) end
  return knots
end

-- Returns the blossom (polar form) of span `span`, which has the control points points[span - degree ..
-- span].
local function blossom(points, knots, degree, span, arguments)
  local row = {}
  for i = 0, degree do row[i] = points[span - degree + i] end
  for level = 1, degree do
    for i = degree, level, -1 do
      local low, high = knots[span - degree + i], knots[span + 1 + i - level]
      row[i] = interpolated(row[i - 1], row[i], (arguments[level] - low) / (high - low))
    end
  end
  return row[degree]
end

-- Returns the position on a curve, its parameter from 0 to count - degree.
local function curve_point(curve, parameter)
  local degree = curve.order - 1
  local span = math.min(math.floor(parameter) + curve.order, #curve.points)
  local arguments = {}
  for level = 1, degree do arguments[level] = parameter end
  return cartesian_point(blossom(curve.points, curve.knots, degree, span, arguments))
end

local function unit(x, y)
  local length = math.sqrt(x * x + y * y)
  if length == 0 then return 0, 0 end
  return x / length, y / length
end

local function tangent_at(curve, parameter, last)
  local a = curve_point(curve, math.max(0, parameter - TANGENT_STEP))
  local b = curve_point(curve, math.min(last, parameter + TANGENT_STEP))
  return { unit(b.x - a.x, b.y - a.y) }
end

-- Adds the arc from a to b that leaves along a tangent, or the line.
local function add_arc(pieces, a, b, tangent)
  local x, y = b.x - a.x, b.y - a.y
  local lateral = 2 * (y * tangent[1] - x * tangent[2])
  local spline_part = { x = b.x, y = b.y, z = b.z }
  pieces[#pieces + 1] = spline_part
  spline_part.length = math.sqrt(x * x + y * y)
  if math.abs(lateral) <= STRAIGHT_MM2 then return end
  local radius = (x * x + y * y) / lateral   -- above 0: the centre is on the left
  spline_part.ccw = radius > 0
  spline_part.first, spline_part.second = a.x - tangent[2] * radius, a.y + tangent[1] * radius
  spline_part.sweep = 2 * math.atan(math.abs(lateral) / 2, x * tangent[1] + y * tangent[2])
  spline_part.length = math.abs(radius) * spline_part.sweep
end

-- Returns the distance of the corners of both arcs' tangents from the ends, equal at both ends. Returns nil
-- if the tangents lead away.
local function tangent_length(a, b, out, into)
  local vx, vy = a.x - b.x, a.y - b.y
  local square = vx * vx + vy * vy
  local along = 2 * (vx * (out[1] + into[1]) + vy * (out[2] + into[2]))
  local turned = 2 * (1 - out[1] * into[1] - out[2] * into[2])
  local rest = math.sqrt(along * along + 4 * turned * square) - along
  if not (rest > 0) then return nil end
  return 2 * square / rest
end

local function add_pair(pieces, a, b, out, into)
  local far = tangent_length(a, b, out, into)
  if far == nil then
    pieces[#pieces + 1] = { x = b.x, y = b.y, z = b.z, length = distance_in_space(a, b) }
    return
  end
  local before = { x = a.x + far * out[1], y = a.y + far * out[2] }
  local after = { x = b.x - far * into[1], y = b.y - far * into[2] }
  local midpoint = { x = (before.x + after.x) / 2, y = (before.y + after.y) / 2, z = (a.z + b.z) / 2 }
  add_arc(pieces, a, midpoint, out)
  add_arc(pieces, midpoint, b, { unit(after.x - midpoint.x, after.y - midpoint.y) })
end

-- Returns arcs and lines along a NURBS with these control points ({x, y, z} in mm) and weights, one after the
-- other. Each has its end x, y, z, its length, and if it is an arc ccw, its centre first, second, and sweep
-- (rad).
function splines.arcs(points, weights, order)
  local held = {}
  for i, point in ipairs(points) do held[i] = weighted_point(point, weights[i]) end
  local curve = { points = held, order = order, knots = uniform_knots(#points, order) }
  local last, section_count = #points - order + 1, SECTIONS_PER_POINT * #points
  local pieces, from, out = {}, points[1], tangent_at(curve, 0, last)
  for i = 1, section_count do
    local parameter = last * i / section_count
    local to = i == section_count and points[#points] or curve_point(curve, parameter)
    local into = tangent_at(curve, parameter, last)
    add_pair(pieces, from, to, out, into)
    from, out = to, into
  end
  return pieces
end

local MIN_STEP, MAX_STEP = 0.002, 0.1   -- of the parameter, from 0 to 1

-- Returns the distance of the middle of the line from `a` to `b` from `middle`, as the sum of its
-- coordinates.
local function off(a, middle, b)
  return math.abs((a.x + b.x) / 2 - middle.x) + math.abs((a.y + b.y) / 2 - middle.y)
end

-- Returns the chords, as lines of splines.arcs, of a cubic Bezier curve with these four control points, as
-- grblHAL selects them (mc_cubic_b_spline() of its motion_control.c). A step of the parameter is that of the
-- chord before, halved until the middle of the chord is within `tolerance` of the curve. If it was so at
-- once, the step is doubled while it stays so.
function splines.chords(points, tolerance)
  local curve = { points = {}, order = #points, knots = uniform_knots(#points, #points) }
  for i, point in ipairs(points) do curve.points[i] = weighted_point(point, 1) end
  local chords, from, at, step = {}, points[1], 0, MAX_STEP
  while at < 1 do
    local to = math.min(at + step, 1)
    local place, halved = curve_point(curve, to), false
    while to - at >= MIN_STEP do
      local middle = curve_point(curve, (at + to) / 2)
      if off(from, middle, place) <= tolerance then break end
      to, place, halved = (at + to) / 2, middle, true
    end
    while not halved and to - at <= MAX_STEP do
      local further = at + 2 * (to - at)
      if further >= 1 then break end
      local candidate = curve_point(curve, further)
      if off(from, place, candidate) > tolerance then break end
      to, place = further, candidate
    end
    if to == 1 then place = points[#points] end
    chords[#chords + 1] = { x = place.x, y = place.y, z = place.z, length = distance_in_space(from, place) }
    step, at, from = to - at, to, place
  end
  return chords
end

-- Returns the four control points of the cubic curve that equals a quadratic one with these three.
function splines.elevate_degree(points)
  local a, middle, b = points[1], points[2], points[3]
  local function toward(point) return { x = point.x + (middle.x - point.x) * 2 / 3,
    y = point.y + (middle.y - point.y) * 2 / 3, z = point.z + (middle.z - point.z) * 2 / 3 } end
  return { a, toward(a), toward(b), b }
end

return splines
