-- Curves by control points as chords. A curve is cut into rational Bezier pieces; a piece is halved until its control
-- points lie within the tolerance of its chord, and the curve lies within their hull.

local TOLERANCE_MM = 0.001   -- between the curve and its chords
local MOST_HALVINGS = 16     -- of a piece
local AXES = { "x", "y", "z" }

splines = {}

-- A control point with weight is {w x, w y, w z, w}: affine sums of such points are those of the curve.
local function weighted(point, weight)
  return { point.x * weight, point.y * weight, point.z * weight, weight }
end

local function mixed(a, b, part)
  local point = {}
  for i = 1, 4 do point[i] = a[i] + (b[i] - a[i]) * part end
  return point
end

local function place_of(point) return { x = point[1] / point[4], y = point[2] / point[4], z = point[3] / point[4] } end

-- Distance of p from the chord a b.
local function beside(p, a, b)
  local along, length = 0, 0
  for _, letter in ipairs(AXES) do
    local way = b[letter] - a[letter]
    along, length = along + (p[letter] - a[letter]) * way, length + way * way
  end
  local part = length > 0 and math.max(0, math.min(1, along / length)) or 0
  local foot = {}
  for _, letter in ipairs(AXES) do foot[letter] = a[letter] + part * (b[letter] - a[letter]) end
  return space_between(p, foot)
end

local function is_flat(piece)
  local first, last = place_of(piece[1]), place_of(piece[#piece])
  for i = 2, #piece - 1 do
    if beside(place_of(piece[i]), first, last) > TOLERANCE_MM then return false end
  end
  return true
end

-- The two halves of a Bezier piece (de Casteljau).
local function halved(piece)
  local left, right, row = {}, {}, piece
  while #row > 0 do
    left[#left + 1] = row[1]
    table.insert(right, 1, row[#row])
    local shorter = {}
    for i = 1, #row - 1 do shorter[i] = mixed(row[i], row[i + 1], 0.5) end
    row = shorter
  end
  return left, right
end

local function add_chords(piece, ends, halvings)
  if halvings == 0 or is_flat(piece) then
    ends[#ends + 1] = place_of(piece[#piece])
    return
  end
  local left, right = halved(piece)
  add_chords(left, ends, halvings - 1)
  add_chords(right, ends, halvings - 1)
end

-- Knots of a NURBS that begins at its first control point and ends at its last, evenly spaced between.
local function even_knots(count, order)
  local knots = {}
  for i = 1, count + order do knots[i] = math.max(0, math.min(i - order, count - order + 1)) end
  return knots
end

-- The blossom (polar form) of span `span`, whose control points are points[span - degree .. span].
local function blossom(points, knots, degree, span, arguments)
  local row = {}
  for i = 0, degree do row[i] = points[span - degree + i] end
  for level = 1, degree do
    for i = degree, level, -1 do
      local low, high = knots[span - degree + i], knots[span + 1 + i - level]
      row[i] = mixed(row[i - 1], row[i], (arguments[level] - low) / (high - low))
    end
  end
  return row[degree]
end

local function bezier_piece(points, knots, degree, span)
  local piece = {}
  for i = 0, degree do
    local arguments = {}
    for level = 1, degree do arguments[level] = level <= degree - i and knots[span] or knots[span + 1] end
    piece[i + 1] = blossom(points, knots, degree, span, arguments)
  end
  return piece
end

-- Ends of the chords of a NURBS with these control points ({x, y, z} in mm) and weights.
function splines.nurbs_chords(points, weights, order)
  local held, ends = {}, {}
  for i, point in ipairs(points) do held[i] = weighted(point, weights[i]) end
  local knots = even_knots(#points, order)
  for span = order, #points do add_chords(bezier_piece(held, knots, order - 1, span), ends, MOST_HALVINGS) end
  return ends
end

function splines.bezier_chords(points)
  local piece, ends = {}, {}
  for i, point in ipairs(points) do piece[i] = weighted(point, 1) end
  add_chords(piece, ends, MOST_HALVINGS)
  return ends
end
