-- RS274/NGC: splines in the XY plane, G5 (cubic), G5.1 (quadratic), G5.2 / G5.3 (NURBS), output as pairs of
-- arcs.

local alarm, check_table, distance_in_space = use("core/basics", "alarm", "check_table", "distance_in_space")
local feed_of_part = use("common/feed", "feed_of_part")
local with_compensation_check, word, word_id = use("core/words", "with_compensation_check", "word", "id")
local axes, motion, path, splines = use "core/axes", use "common/motion", use "core/path", use "common/splines"

local SAME_MM = 1e-9
local DEFAULT_ORDER = 3
local MAX_CONTROL_POINTS = 10000
local AXES = { "x", "y", "z" }

local function machine_target(point)
  local target = {}
  for _, letter in ipairs(AXES) do
    if axes.is_rotary[letter] ~= nil then target[letter] = point[letter] end
  end
  return target
end

-- Outputs consecutive arcs and lines, as splines.arcs and splines.chords return them.
local function output_segments(pieces)
  local whole = 0
  for _, spline_part in ipairs(pieces) do whole = whole + spline_part.length end
  local feed = core.take_feed()
  for _, spline_part in ipairs(pieces) do
    if spline_part.length > SAME_MM then
      -- The time of the block (G93) is distributed over the parts by their lengths.
      local target, part_feed = machine_target(spline_part), feed_of_part(feed, spline_part.length / whole)
      if spline_part.sweep then
        path.arc("xy", spline_part.ccw, spline_part.first, spline_part.second, spline_part.sweep, target, part_feed)
      else
        path.line(target, part_feed, "spline")
      end
    end
  end
end

-- A Bezier curve is a NURBS whose order is the number of its points.
local function output_bezier(points)
  if core.spline_chord_mm > 0 then
    return output_segments(splines.chords(#points == 3 and splines.elevate_degree(points) or points, core.spline_chord_mm))
  end
  local weights = {}
  for i = 1, #points do weights[i] = 1 end
  output_segments(splines.arcs(points, weights, #points))
end

-- --- The words ---

local function here()
  local point = {}
  for _, letter in ipairs(AXES) do point[letter] = axes.is_rotary[letter] ~= nil and core.position(letter) or 0 end
  return point
end

-- Returns the point at a vector of the program from `point`.
local function moved(point, x, y)
  local dx, dy, dz = core.direction(x * core.unit_mm(), y * core.unit_mm(), 0)
  return { x = point.x + dx, y = point.y + dy, z = point.z + dz }
end

local function check(words, name, letters)
  check_table(words, name)
  if core.plane() ~= "xy" then alarm("mode", "%s is a curve in the XY plane (G17)", name) end
  for letter, value in pairs(words) do
    if letters:find(" " .. tostring(letter) .. " ", 1, true) == nil then
      alarm("word-out-of-place", "%s is a curve in X and Y and does not accept the word '%s'", name, tostring(letter))
    end
    if type(value) ~= "number" then alarm("script", "%s: the value of %s is not a number", name, letter:upper()) end
  end
end

-- Returns both `a` and `b`, or nil if neither is given and that is allowed.
local function pair(words, a, b, name, optional)
  if words[a] == nil and words[b] == nil and optional then return nil end
  if words[a] == nil or words[b] == nil then alarm("word-missing", "%s needs %s and %s", name, a:upper(), b:upper()) end
  return { words[a], words[b] }
end

-- G5 and G5.1 apply to their own block only; the motion before them remains modal.

local last_g5   -- its end point and direction: a next one that begins there continues in that direction

-- G5: I J is the offset from the start to the first control point, P Q from the end to the second.
word("G5", function(words)
  words = words or {}
  check(words, "G5", " x y i j p q ")
  local start = here()
  local continues = last_g5 ~= nil and distance_in_space(last_g5.point, start) < SAME_MM
  local first = pair(words, "i", "j", "G5", true) or continues and last_g5.lead or { 0, 0 }
  local last = pair(words, "p", "q", "G5")
  -- grblHAL uses the negated P and Q of the block itself, while others use those of the block before.
  if continues and words.i == nil and core.spline_chord_mm > 0 then first = { -last[1], -last[2] } end
  local target, named = core.target(words, " i j p q ")
  if not named then alarm("word-missing", "G5 needs its end, X or Y") end
  output_bezier { start, moved(start, first[1], first[2]), moved(target, last[1], last[2]), target }
  last_g5 = { point = target, lead = { -last[1], -last[2] } }
end)

-- G5.1: I J is the offset from the start to the only control point between start and end.
word("G5_1", function(words)
  words = words or {}
  check(words, "G5.1", " x y i j ")
  local middle = pair(words, "i", "j", "G5.1")
  local target, named = core.target(words, " i j ")
  if not named then alarm("word-missing", "G5.1 needs its end, X or Y") end
  local start = here()
  output_bezier { start, moved(start, middle[1], middle[2]), target }
end)

local nurbs   -- control points, weights and order of the curve between G5.2 and G5.3

local function add_control_point(words, first)
  check(words, "G5.2", " x y p l ")
  if words.l ~= nil and words.l > 1 then
    if words.l % 1 ~= 0 then
      alarm("word-value", "L of G5.2 (order of the curve) must be an integer, not %.10g", words.l)
    end
    nurbs.order = math.tointeger(words.l)
  end
  if words.p ~= nil and words.p <= 0 then alarm("word-value", "P of G5.2 (weight) must be greater than 0, not %.10g", words.p) end
  if words.x == nil and words.y == nil then
    if not first then alarm("word-missing", "a control point needs X and Y") end
    nurbs.weights[1] = words.p or 1   -- of the start
    return
  end
  if not first and words.p == nil then alarm("word-missing", "a control point needs P, its weight") end
  if words.x == nil or words.y == nil then alarm("word-value", "a control point needs X and Y") end
  if #nurbs.points == MAX_CONTROL_POINTS then
    alarm("word-value", "a curve may have at most %d control points", MAX_CONTROL_POINTS)
  end
  nurbs.points[#nurbs.points + 1] = core.target(words, " p l ")
  nurbs.weights[#nurbs.weights + 1] = words.p or 1
end

local next_point = motion.new("G5.2", core.word(word_id(), with_compensation_check("G5_2", function(words)
  add_control_point(words or {}, false)
end)))

word("G5_2", function(words)
  local going_on = nurbs ~= nil and core.motion() == "G5.2"
  if not going_on then nurbs = { points = { here() }, weights = { 1 }, order = DEFAULT_ORDER } end
  core.make_modal(next_point)
  add_control_point(words or {}, not going_on)
end)

word("G5_3", function()
  if nurbs == nil or core.motion() ~= "G5.2" then
    alarm("arc", "G5.3 ends a curve that G5.2 begins, but no curve is active")
  end
  local curve = nurbs
  nurbs = nil
  motion.end_motion()
  if #curve.points < curve.order then
    alarm("word-missing", "a curve of order %d needs %d control points including its start, but has %d",
      curve.order, curve.order,
      #curve.points)
  end
  output_segments(splines.arcs(curve.points, curve.weights, curve.order))
end)
