-- Canned cycles: the common part of both dialects. A hole is at a position on the two axes of the active
-- plane, the tool moves in along the third. Cycles are calculated in program coordinates, so that offsets,
-- rotation and mirror image apply to each stroke.

local alarm, snap_to_integer = use("core/basics", "alarm", "snap_to_integer")
local word = use("core/words", "word")
local modal_cycles, peck_tolerance_mm = use("core/dialect", "modal_cycles", "peck_tolerance_mm")
local path, state = use "core/path", use "core/state"

local SAME_MM = 1e-9    -- a stroke below this length is no move
local MAX_PECKS = 100000
local MAX_REPEATS = 9999

local cycle_names = {}
for _, name in ipairs(modal_cycles) do cycle_names[name] = true end

-- Returns true if the modal motion of that name is a canned cycle.
local function is_cycle(name) return cycle_names[name] == true end

-- End level of the tool after a cycle: "initial" (G98) or "r" (G99).
word("G98", function() state.return_level = "initial" end)
word("G99", function() state.return_level = "r" end)

-- Returns a word of a cycle: a number, or nil if it is left out.
local function cycle_word(words, letter, name)
  local value = words[letter]
  if value ~= nil and type(value) ~= "number" then
    alarm("script", "%s: the value of %s is not a number", name, letter:upper())
  end
  return value
end

local function cycle_dwell(words, name)
  local seconds = cycle_word(words, "p", name)
  if seconds ~= nil and seconds < 0 then
    alarm("word-value", "P of %s must be a dwell of at least 0 s, not %.10g", name, seconds)
  end
  return seconds
end

local function cycle_repeats(value, letter, name)
  if value == nil then return 1 end
  value = snap_to_integer(value)
  if value % 1 ~= 0 or value < 0 or value > MAX_REPEATS then
    alarm("word-value", "%s of %s must be an integer number of repeats up to %d, not %.10g", letter, name, MAX_REPEATS, value)
  end
  return math.tointeger(value)
end

-- Returns a tool over a plane, moved by the plane's three axes in program coordinates (mm).
local function cycle_tool(plane, start)
  local tool = { start[plane.first], start[plane.second], start[plane.third] }

  local function target(first, second, third)
    local near = math.abs(first - tool[1]) < SAME_MM and math.abs(second - tool[2]) < SAME_MM
      and math.abs(third - tool[3]) < SAME_MM
    if near then return nil end
    tool[1], tool[2], tool[3] = first, second, third
    return core.to_machine { [plane.first] = first, [plane.second] = second, [plane.third] = third }
  end

  function tool.rapid_to(first, second, third)
    local point = target(first, second, third)
    if point ~= nil then path.rapid(point) end
  end
  function tool.feed_to(first, second, third)
    local point = target(first, second, third)
    if point ~= nil then path.line(point) end
  end
  function tool.rapid(third) tool.rapid_to(tool[1], tool[2], third) end
  function tool.feed(third) tool.feed_to(tool[1], tool[2], third) end
  return tool
end

-- Returns the depths at which a hole drilled in pecks of `step` is left, above its bottom. A remainder above
-- the bottom from rounding is no peck.
local function pecks(from, bottom, step, name)
  if not (step > 0) then alarm("word-value", "Q of %s (peck depth) must be greater than 0, not %.10g", name, step) end
  if (from - bottom) / step > MAX_PECKS then
    alarm("word-value", "Q %.10g of %s is too small: the hole of %.10g would need more than %d pecks", step, name,
      from - bottom,
      MAX_PECKS)
  end
  local depths = {}
  local depth = from - step
  while depth - bottom > peck_tolerance_mm do
    depths[#depths + 1] = depth
    depth = depth - step
  end
  return depths
end

-- Levels count in the work coordinate system; time per stroke has no meaning, nor has a path next to the
-- hole.
local function check_cycle_modes(name)
  if core.in_machine_frame() then alarm("mode", "%s cannot be used with G53, which requires G0 or G1", name) end
  if core.feed_mode() == "inverse" then
    alarm("mode", "%s cannot be used with inverse time feed (G93); G94 or G95 is needed", name)
  end
end

return {
  is_cycle = is_cycle, word = cycle_word, dwell = cycle_dwell, repeats = cycle_repeats, tool = cycle_tool, pecks = pecks,
  check_modes = check_cycle_modes,
}
