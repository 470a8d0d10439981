-- Canned cycles of the 9/Series; if its manual is silent they are those of its nearest relatives. R and the
-- depth are levels of the series: in incremental dimensions R counts from the initial level and the depth
-- from R. They and P, Q and the shift are valid, for all cycles, until G80 or a motion code ends the series.

local alarm, check_table = use("core/basics", "alarm", "check_table")
local with_compensation_check, word, word_id = use("core/words", "with_compensation_check", "word", "id")
local axes, cycles, motion, overrides, path = use "core/axes", use "common/cycles", use "common/motion", use "common/overrides", use "core/path"
local plane_view, polar, spindle, state = use "core/plane_view", use "common/polar", use "common/spindle", use "core/state"

-- The builder of a machine sets these on the controller; they are usual values.
local CHIP_BREAK_RETRACT_MM = 1   -- G73: how far the tool is drawn back after each peck
local PECK_CLEARANCE_MM = 1       -- G83: end of the rapid move back into the hole, above the last depth

local held = {}
local motion_before_series   -- the modal motion to which G80 leads back

-- Each cycle begins at the hole, at the R level. `hole` has r, bottom, clear (levels, mm), p (s, or nil), q (mm).
local strokes = {}

local function dwell(hole)
  if hole.p ~= nil and hole.p > 0 then path.dwell(hole.p) end
end

-- Calls reach(depth, back) for each peck above the bottom; `back` is the level `retract` before it, at most
-- R. A hole may lead in either direction.
local function for_each_peck(hole, name, retract, reach)
  local up = hole.bottom <= hole.r and 1 or -1
  for _, depth in ipairs(cycles.pecks(up * hole.r, up * hole.bottom, hole.q, name)) do
    reach(up * depth, up * math.min(depth + retract, up * hole.r))
  end
end

function strokes.G81(tool, hole)
  tool.feed(hole.bottom)
  tool.rapid(hole.clear)
end

function strokes.G82(tool, hole)
  tool.feed(hole.bottom)
  dwell(hole)
  tool.rapid(hole.clear)
end

function strokes.G73(tool, hole)
  for_each_peck(hole, "G73", CHIP_BREAK_RETRACT_MM, function(depth, back)
    tool.feed(depth)
    dwell(hole)
    tool.rapid(back)
  end)
  strokes.G82(tool, hole)
end

function strokes.G83(tool, hole)
  for_each_peck(hole, "G83", PECK_CLEARANCE_MM, function(depth, back)
    tool.feed(depth)
    tool.rapid(hole.r)
    tool.rapid(back)
  end)
  strokes.G82(tool, hole)
end

local function tap(tool, hole, forth, back)
  if state.spindle ~= forth then spindle.turn(forth) end
  overrides.without(function()
    tool.feed(hole.bottom)
    spindle.turn(nil)
    dwell(hole)
    spindle.turn(back)
    tool.feed(hole.r)
  end)
  spindle.turn(nil)
  spindle.turn(forth)
  tool.rapid(hole.clear)
end

function strokes.G74(tool, hole) tap(tool, hole, "ccw", "cw") end
function strokes.G84(tool, hole) tap(tool, hole, "cw", "ccw") end

function strokes.G85(tool, hole)
  tool.feed(hole.bottom)
  tool.feed(hole.r)
  tool.rapid(hole.clear)
end

function strokes.G86(tool, hole)
  local direction = state.spindle or "cw"
  tool.feed(hole.bottom)
  dwell(hole)
  spindle.turn(nil)
  tool.rapid(hole.clear)
  spindle.turn(direction)
end

-- Moves along the hole to a level, with the tool's point off the wall.
local function move_with_shift(tool, hole, level)
  local direction = state.spindle or "cw"
  local first, second = tool[1], tool[2]
  spindle.orient()
  tool.rapid_to(first + hole.shift_first, second + hole.shift_second, tool[3])
  tool.rapid(level)
  tool.rapid_to(first, second, level)
  spindle.turn(direction)
end

-- Fine boring.
function strokes.G76(tool, hole)
  tool.feed(hole.bottom)
  dwell(hole)
  move_with_shift(tool, hole, hole.clear)
end

-- Back boring: past the wall to R, which is below, then up to the depth; it always ends at the initial level.
function strokes.G87(tool, hole)
  move_with_shift(tool, hole, hole.r)
  tool.feed(hole.bottom)
  dwell(hole)
  move_with_shift(tool, hole, hole.initial)
end

-- The operator retracts the tool from the hole, at least to R, and starts the program again.
function strokes.G88(tool, hole)
  local direction = state.spindle or "cw"
  tool.feed(hole.bottom)
  dwell(hole)
  spindle.turn(nil)
  path.event("stop", "G88: the operator retracts the tool")
  tool.rapid(hole.r)
  tool.rapid(hole.clear)
  spindle.turn(direction)
end

function strokes.G89(tool, hole)
  tool.feed(hole.bottom)
  dwell(hole)
  tool.feed(hole.r)
  tool.rapid(hole.clear)
end

local is_shifted = { G76 = true, G87 = true }
local increment = { x = "u", y = "v", z = "w" }
local non_position_words = { r = true, p = true, q = true, i = true, j = true, k = true, l = true, f = true }

local function length(words, letter, name)
  local value = cycles.word(words, letter, name)
  return value and value * core.unit_mm()
end

-- Stores the levels that the block gives.
local function read_levels(words, name, p)
  local r, depth = length(words, "r", name), length(words, p.third, name)
  local from_r = axes.is_rotary[increment[p.third]] == nil and length(words, increment[p.third], name) or nil
  if r ~= nil then held.r = core.is_incremental() and held.initial + r or r end
  if held.r == nil and (from_r ~= nil or core.is_incremental() and depth ~= nil) then
    alarm("word-missing", "%s requires R, the level from which its depth is measured", name)
  end
  if depth ~= nil then held.bottom = core.is_incremental() and held.r + depth or depth end
  if from_r ~= nil then held.bottom = held.r + from_r end
end

-- Returns the shift of G76 and G87: along the centre words, or Q along the first axis of the plane.
local function read_wall_clearance(words, name, p)
  local first, second = length(words, p.i, name), length(words, p.j, name)
  if first ~= nil or second ~= nil then
    held.shift_first, held.shift_second = first or 0, second or 0
  elseif words.q ~= nil then
    held.shift_first, held.shift_second = length(words, "q", name), 0
  end
end

local function read_words(words, name, p)
  read_levels(words, name, p)
  held.p = cycles.dwell(words, name) or held.p
  if is_shifted[name] then
    read_wall_clearance(words, name, p)
  else
    held.q = length(words, "q", name) or held.q
  end
end

-- Returns the words of the position of the hole, and true if the block drills at all.
local function split(words, p)
  local place, drills = {}, words.r ~= nil or words[p.third] ~= nil
  for key, value in pairs(words) do
    local depth = key == p.third or key == increment[p.third] and axes.is_rotary[key] == nil
    if depth then
      drills = true
    elseif not non_position_words[key] then
      place[key], drills = value, true
    end
  end
  return place, drills
end

-- Rapid to the hole, at the present level of the tool; other axes named in the block move along.
local function move_to_hole(place, p)
  local over = core.to_program((core.target(polar.resolve(place))))
  over[p.third] = axes.program_position()[p.third]
  path.rapid(core.to_machine(over))
end

local function read_repeats(words, name)
  if words.l ~= nil and words.k ~= nil and not is_shifted[name] then
    alarm("word-out-of-place", "%s requires its repeats as L or as K, not both", name)
  end
  if words.l == nil and not is_shifted[name] then return cycles.repeats(cycles.word(words, "k", name), "K", name) end
  return cycles.repeats(cycles.word(words, "l", name), "L", name)
end

local function check_words(name, p)
  if held.r == nil then alarm("word-missing", "%s requires R, the retract level", name) end
  if held.bottom == nil then alarm("word-missing", "%s requires %s, the depth of the hole", name, p.third:upper()) end
  if (name == "G73" or name == "G83") and held.q == nil then
    alarm("word-missing", "%s requires Q, the depth of a peck", name)
  end
  if is_shifted[name] and held.shift_first == 0 and held.shift_second == 0 then
    alarm("word-missing", "%s requires the shift away from the wall: Q, or %s and %s", name, p.i:upper(), p.j:upper())
  end
end

local function begin_cycle_series(p)
  held = { initial = axes.program_position()[p.third], plane = core.plane(), shift_first = 0, shift_second = 0 }
end

local function drill(name, words)
  check_table(words, name)
  words = words or {}
  cycles.check_modes(name)
  local p = plane_view.planes[core.plane()]
  if held.plane ~= core.plane() then begin_cycle_series(p) end
  read_words(words, name, p)
  local place, drills = split(words, p)
  local repeats = read_repeats(words, name)
  if not drills or repeats == 0 then return end
  check_words(name, p)
  local hole = setmetatable({}, { __index = held })
  hole.clear = state.return_level == "r" and held.r or held.initial
  for _ = 1, repeats do
    move_to_hole(place, p)
    local tool = cycles.tool(p, axes.program_position())
    if name ~= "G87" then tool.rapid(held.r) end
    strokes[name](tool, hole)
  end
end

for name in pairs(strokes) do
  local modal = motion.new(name, core.word(word_id(), with_compensation_check(name, function(words) drill(name, words) end)))
  word(name, function(words)
    if not cycles.is_cycle(core.motion()) then
      motion_before_series = core.motion_id()
      begin_cycle_series(plane_view.planes[core.plane()])
    end
    core.make_modal(modal)
    drill(name, words)
  end)
end

-- The end of a series: the motion before it is modal again.
word("G80", function()
  if not cycles.is_cycle(core.motion()) then return end
  local name = motion.names[motion_before_series]
  if name == "G0" or name == "G1" then
    env[name]()   -- which G0 and G1 are in use may have changed meanwhile
  else
    core.make_modal(motion.active_variant(motion_before_series))
  end
end)
