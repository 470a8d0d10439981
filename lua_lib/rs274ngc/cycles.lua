-- Canned cycles of RS274/NGC, as LinuxCNC 2.9 executes them. R, Z, Q, P, I, J, K and the initial level are
-- kept as they were written, in program units. After a change of units or offsets they are interpreted with
-- the new ones, as in LinuxCNC.

local dialect = use "core/dialect"
local alarm, check_table = use("core/basics", "alarm", "check_table")
local with_compensation_check, word, word_id = use("core/words", "with_compensation_check", "word", "id")
local axes, cycles, motion, ngc_modes, overrides =
  use "core/axes", use "common/cycles", use "common/motion", dialect.use "modes", use "common/overrides"
local path, plane_view, spindle, state = use "core/path", use "core/plane_view", use "common/spindle", use "core/state"

local held = {}   -- words of the cycle that is modal, and `initial`, the level at which the series of cycles began

-- Returns the nearest short decimal: the value as written in a program, without rounding errors of unit
-- conversion.
local function snap(value) return math.floor(value * 1e9 + 0.5) / 1e9 end

-- Returns true if level `a` is higher than `b` by more than rounding.
local function above(a, b) return a - b > 1e-9 end

local function required(words, letter, name, again)
  local value = cycles.word(words, letter, name)
  if value == nil and again then value = held[letter] end
  if value == nil then
    alarm("word-missing", "%s needs %s; it is modal only while the same cycle repeats", name, letter:upper())
  end
  held[letter] = value
  return value
end

local function require_spindle(name)
  if state.spindle == nil then alarm("spindle", "%s needs a rotating spindle (M3 or M4)", name) end
  return state.spindle
end

-- Each cycle begins above the hole, at the R level.
local strokes = {}

function strokes.G81(hole)
  hole.feed(hole.bottom)
  hole.rapid(hole.clear)
end

function strokes.G82(hole)
  hole.feed(hole.bottom)
  path.dwell(hole.p)
  hole.rapid(hole.clear)
end

local function feed_and_dwell(hole, depth)
  hole.feed(depth)
  if core.drilling.dwell > 0 then path.dwell(core.drilling.dwell) end
end

local function peck(hole, name, retract)
  local feeds_down = retract and core.drilling.feeds_down
  for _, depth in ipairs(cycles.pecks(hole.r, hole.bottom, hole.q, name)) do
    feed_and_dwell(hole, depth)
    if retract then hole.rapid(feeds_down and hole.clear or hole.r) end
    if not feeds_down then hole.rapid(depth + core.drilling.clearance_mm / core.unit_mm()) end
  end
  feed_and_dwell(hole, hole.bottom)
  hole.rapid(hole.clear)
end

function strokes.G73(hole) peck(hole, "G73", false) end
function strokes.G83(hole) peck(hole, "G83", true) end

-- In ZX and YZ, LinuxCNC 2.9 assigns the strokes of G74 and G84 to the wrong axes. gsim follows its canonical
-- output, with a warning.
local function exchange_axes(hole, level)
  if core.plane() == "zx" then return hole.second, level, hole.first end
  return level, hole.first, hole.second
end

local function tap(hole, name, forth, back)
  if require_spindle(name) ~= forth then
    alarm("spindle", "%s needs the spindle to rotate %s", name,
      forth == "cw" and "clockwise (M3)" or "counterclockwise (M4)")
  end
  local feed = hole.feed
  if core.plane() ~= "xy" then
    core.warn(name .. " outside the XY plane: as in LinuxCNC 2.9 its strokes move swapped axes; use G33.1")
    feed = function(level) hole.feed_to(exchange_axes(hole, level)) end
  end
  overrides.without(function()
    feed(hole.bottom)
    spindle.turn(nil)
    spindle.turn(back)
    if hole.p > 0 then path.dwell(hole.p) end
    feed(hole.clear)
  end)
  spindle.turn(nil)
  spindle.turn(forth)
end

function strokes.G84(hole) tap(hole, "G84", "cw", "ccw") end
function strokes.G74(hole) tap(hole, "G74", "ccw", "cw") end

function strokes.G85(hole)
  hole.feed(hole.bottom)
  hole.feed(hole.r)
  hole.rapid(hole.clear)
end

function strokes.G86(hole)
  local direction = require_spindle("G86")
  hole.feed(hole.bottom)
  path.dwell(hole.p)
  spindle.turn(nil)
  hole.rapid(hole.clear)
  spindle.turn(direction)
end

-- Back boring: through the hole offset from its axis, then up from below.
function strokes.G87(hole)
  local direction = require_spindle("G87")
  local first, second = hole.first + hole.shift_first, hole.second + hole.shift_second
  hole.rapid_to(first, second, hole.r)
  spindle.orient()
  hole.rapid_to(first, second, hole.bottom)
  hole.rapid(hole.bottom)
  spindle.turn(direction)
  hole.feed(hole.middle)
  hole.feed(hole.bottom)
  spindle.orient()
  hole.rapid_to(first, second, hole.bottom)
  hole.rapid_to(first, second, hole.clear)
  hole.rapid(hole.clear)
  spindle.turn(direction)
end

-- The operator retracts the tool; the program continues as if from the clearance level.
function strokes.G88(hole)
  local direction = require_spindle("G88")
  hole.feed(hole.bottom)
  path.dwell(hole.p)
  spindle.turn(nil)
  path.event("stop", "G88: the operator retracts the tool")
  spindle.turn(direction)
end

function strokes.G89(hole)
  hole.feed(hole.bottom)
  path.dwell(hole.p)
  hole.feed(hole.clear)
end

-- Words that a cycle needs in addition to R and the depth word, if it differs from the cycle before.
local needs_dwell = { G82 = true, G86 = true, G88 = true, G89 = true }
local needs_peck = { G73 = true, G83 = true }

local function read_words(hole, words, name, p, again)
  local dwell = cycles.dwell(words, name)
  if needs_dwell[name] then
    hole.p = required(words, "p", name, again)
  elseif name == "G74" or name == "G84" then
    held.p = dwell or held.p   -- kept even across other cycles
    hole.p = held.p or 0
  end
  if needs_peck[name] then hole.q = required(words, "q", name, again) end
  if name == "G87" then
    hole.shift_first = required(words, p.i, name, again)
    hole.shift_second = required(words, p.j, name, again)
    hole.middle = required(words, p.k, name, again)
    if core.is_incremental() then hole.middle = hole.middle + hole.bottom end
  end
end

local function check_axes(words, name, p)
  local named = words.radius ~= nil or words.angle ~= nil
  for _, axis in ipairs(axes.list) do
    local letter = axis.letter
    if words[letter] ~= nil then
      named = true
      if letter ~= p.first and letter ~= p.second and letter ~= p.third then
        alarm("word-out-of-place", "%s moves only X, Y and Z; %s cannot be in its block", name, letter:upper())
      end
    end
  end
  if not named then alarm("word-missing", "%s needs axis words", name) end
  if (words.radius ~= nil or words.angle ~= nil) and (core.plane() ~= "xy" or words.x ~= nil or words.y ~= nil) then
    alarm("mode", "%s accepts @ and ^ only in the XY plane, and not together with X or Y", name)
  end
  ngc_modes.check_spindle(words, name)
end

-- Returns an axis word of a cycle, in program units, or nil if it is missing.
local function axis_word(words, letter, name)
  local value = cycles.word(words, letter, name)
  return value and axes.word_in_units(letter, value)
end


-- Returns a function that steps from hole to hole in incremental dimensions.
local function make_stepper(words, name, p)
  local first, second = axis_word(words, p.first, name) or 0, axis_word(words, p.second, name) or 0
  local radius, angle = cycles.word(words, "radius", name) or 0, cycles.word(words, "angle", name) or 0
  return function(hole)
    hole.first, hole.second = hole.first + first, hole.second + second
    if radius == 0 and angle == 0 then return end
    if hole.first == 0 and hole.second == 0 then
      alarm("word-value", "%s: an incremental @ or ^ has no direction at the zero point", name)
    end
    local polar_radius = math.sqrt(hole.first ^ 2 + hole.second ^ 2) + radius
    local turn = math.atan(hole.second, hole.first) + math.rad(angle)
    hole.first, hole.second = polar_radius * math.cos(turn), polar_radius * math.sin(turn)
  end
end

local function set_absolute_position(hole, words, name, p)
  if words.radius ~= nil or words.angle ~= nil then
    local polar_radius = cycles.word(words, "radius", name) or math.sqrt(hole.first ^ 2 + hole.second ^ 2)
    local angle = cycles.word(words, "angle", name)
    local turn = angle and math.rad(angle) or math.atan(hole.second, hole.first)
    hole.first, hole.second = polar_radius * math.cos(turn), polar_radius * math.sin(turn)
    return
  end
  hole.first = axis_word(words, p.first, name) or hole.first
  hole.second = axis_word(words, p.second, name) or hole.second
end

-- Adds strokes in program units, using a tool that moves in mm.
local function add_strokes(hole, tool)
  local unit = core.unit_mm()
  function hole.rapid_to(first, second, third) tool.rapid_to(first * unit, second * unit, third * unit) end
  function hole.feed_to(first, second, third) tool.feed_to(first * unit, second * unit, third * unit) end
  function hole.rapid(third) hole.rapid_to(hole.first, hole.second, third) end
  function hole.feed(third) hole.feed_to(hole.first, hole.second, third) end
end

local function levels(hole, words, name, p, again, current)
  hole.r = required(words, "r", name, again)
  local depth = axis_word(words, p.third, name)
  if depth == nil and again then depth = held.depth end
  if depth == nil then alarm("word-missing", "%s requires %s, the depth of the hole", name, p.third:upper()) end
  held.depth = depth
  local old = held.initial
  if core.is_incremental() then
    hole.r = hole.r + old
    hole.bottom = hole.r + depth
  else
    hole.bottom = depth
  end
  if above(hole.bottom, hole.r) then
    alarm("word-value", "%s: R %.10g is below the bottom of the hole, %s%.10g", name, hole.r, p.third:upper(),
      hole.bottom)
  end
  -- The tool first moves straight up to the R level if it is below it.
  if above(hole.r, old) then
    hole.rapid(hole.r)
    old, current = hole.r, hole.r
  end
  hole.clear = state.return_level == "r" and hole.r or old
  return current
end

-- After G88, and after G84 outside of XY, the tool is not at the position that the program assumes.
local function displaces_tool(name)
  return name == "G88" or core.plane() ~= "xy" and (name == "G74" or name == "G84")
end

-- Cycles that a controller may read without executing them.
local bores = { G85 = true, G86 = true, G89 = true }

local UNKNOWN_POSITION = 0 / 0

local function drill(name, words, before)
  check_table(words, name)
  words = words or {}
  cycles.check_modes(name)
  if bores[name] and not core.drilling.bores then
    core.warn(name .. ": this controller reads it but does not move")
    return
  end
  local p, again = plane_view.planes[core.plane()], before == name
  check_axes(words, name, p)
  local repeats = cycles.repeats(cycles.word(words, "l", name), "L", name)
  if repeats == 0 then alarm("word-value", "%s cannot be repeated 0 times; L must be 1 or more", name) end
  local here, unit = axes.program_position(), core.unit_mm()
  local current = snap(here[p.third] / unit)
  if not cycles.is_cycle(before) then held.initial = current end
  local hole = { first = snap(here[p.first] / unit), second = snap(here[p.second] / unit) }
  local tool = cycles.tool(p, here)
  if path.is_displaced() then tool[3] = UNKNOWN_POSITION end   -- whatever the first stroke, it is a move
  add_strokes(hole, tool)
  current = levels(hole, words, name, p, again, current)
  read_words(hole, words, name, p, again)
  local step = core.is_incremental() and make_stepper(words, name, p)
  if not step then set_absolute_position(hole, words, name, p) end
  -- The moves of a cycle follow the exact path in every path mode.
  path.call_in_mode("exact_path", function()
    for pass = 1, repeats do
      if step then step(hole) end
      -- The move to the first hole is at the level of the tool, moves between repeats are at the clearance
      -- level.
      local level = pass == 1 and above(current, hole.r) and current or hole.clear
      hole.rapid_to(hole.first, hole.second, level)
      hole.rapid(hole.r)
      strokes[name](hole)
    end
  end)
  if displaces_tool(name) then
    path.continue_from(core.to_machine {
      [p.first] = hole.first * unit, [p.second] = hole.second * unit, [p.third] = hole.clear * unit })
  end
end

for name in pairs(strokes) do
  local modal = motion.new(name, core.word(word_id(), with_compensation_check(name, function(words) drill(name, words, name) end)))
  word(name, function(words)
    local before = core.motion()
    core.make_modal(modal)
    drill(name, words, before)
  end)
end

word("G80", motion.end_motion)
