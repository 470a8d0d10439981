-- RS274/NGC: feed modes, spindle and coolant, path modes, the arc centre mode.

local alarm, given = use("core/basics", "alarm", "given")
local word = use("core/words", "word")
local axes, path, spindle, state = use "core/axes", use "core/path", use "common/spindle", use "core/state"

local MM_PER_M, MM_PER_FOOT = 1000, 304.8
local FULL_TURN = 360

core.set_letters_uvw(false)            -- U, V and W are axes or invalid
core.set_inverse_time_of_arcs(false)   -- 60/F s for a complete arc, as for a line

-- The only spindle is $0. For words that may be for `all` spindles, $-1 is another name of it.
local function check_spindle(words, name, all)
  local number = words and words.spindle
  if number ~= nil and number ~= 0 and not (all and number == -1) then
    alarm("spindle", "%s: the only spindle is $0; $%.10g does not exist", name, number)
  end
end

word("F", function(value)
  if not given(value, "F") then return end
  if value < 0 then alarm("word-value", "F must be a feed of at least 0, not %.10g", value) end
  if core.feed_mode() ~= "inverse" then state.feed = value end   -- in G93 F is that of its block
  if value > 0 then core.set_feed(value) else core.clear_feed() end
end)

local function reset_feed()
  state.feed = 0
  core.clear_feed()
end

-- G94 and G95 drop F even if they are already active: F must come after them, or in their block.
local function feed_mode(name, mode)
  word(name, function()
    core.set_feed_mode(mode)
    if mode ~= "inverse" then reset_feed() end
  end)
end
feed_mode("G93", "inverse")
feed_mode("G94", "minute")
feed_mode("G95", "revolution")

-- --- Spindle ---

-- Constant surface speed (G96): S is m/min or feet/min, D the max rpm; nil with G97.
local surface

-- Returns the speed at the X of the programmed position; the path does not change it afterwards.
local function surface_rpm()
  if state.spindle_word == 0 then return 0 end
  local radius_mm = math.abs(axes.program_position().x or 0)
  local unit_mm = core.unit_mm() == 1 and MM_PER_M or MM_PER_FOOT
  return math.min(surface.max_rpm, state.spindle_word * unit_mm / (2 * math.pi * radius_mm))
end

local function set_speed()
  local rpm = surface and surface_rpm() or state.spindle_word
  if rpm == math.huge then   -- LinuxCNC leaves that to its spindle
    core.warn("G96 at X0: the speed has no maximum and is set to 0; program the maximum with D")
    rpm = 0
  end
  spindle.set_speed(rpm)
end

local function speed(value, name)
  if type(value) ~= "number" or value < 0 then
    alarm("word-value", "S%s must be a speed of at least 0, not %s", name, tostring(value))
  end
  state.spindle_word = value
end

word("S", function(value)
  if not given(value, "S") then return end
  local before = core.spindle_rpm()
  speed(value, "")
  set_speed()
  if state.spindle then path.wait_for(core.spindle_rpm() ~= before) end
end)

word("G96", function(words)
  check_spindle(words, "G96", true)
  words = words or {}
  if words.s then
    path.wait_at("S")
    speed(words.s, " of G96")
  end
  local most = math.abs(words.d or 0)
  surface = { max_rpm = most > 0 and most or math.huge }
  core.warn("G96: the spindle speed is computed at the block with S and does not follow X from there")
  set_speed()
end)

word("G97", function(words)
  check_spindle(words, "G97", true)
  surface = nil
  if words and words.s then
    path.wait_at("S")
    speed(words.s, " of G97")
  end
  set_speed()
end)

local function spindle_word(name, direction)
  word(name, function(words)
    check_spindle(words, name, true)
    spindle.turn(direction)
  end)
end
spindle_word("M3", "cw")
spindle_word("M4", "ccw")
spindle_word("M5", nil)

local directions = { [0] = "shortest way", [1] = "clockwise", [2] = "counterclockwise" }

word("M19", function(words)
  check_spindle(words, "M19", true)
  words = words or {}
  local angle, direction = words.r or 0, directions[words.p or 0]
  if angle < 0 or angle > FULL_TURN then
    alarm("word-value", "R of M19 must be an angle from 0 to 360 degrees, not %.10g", angle)
  end
  if direction == nil then alarm("word-value", "P of M19 must be 0, 1 or 2: shortest direction, clockwise or counterclockwise") end
  if words.q ~= nil and words.q <= 0 then alarm("word-value", "Q of M19 must be a time greater than 0 s, not %.10g", words.q) end
  state.spindle = nil
  local within = words.q and (", within %.10g s"):format(words.q) or ""   -- it is there at once
  path.event("spindle_orient", ("%.10g deg, %s%s"):format(angle, direction, within))
end)

-- --- Coolant ---

word("M7", function()
  local changed = not state.mist
  state.mist = true
  path.event("mist_on", nil, nil, changed)
end)

word("M8", function()
  local changed = not state.flood
  state.flood = true
  path.event("flood_on", nil, nil, changed)
end)

word("M9", function()
  local changed = state.mist or state.flood or false
  state.mist, state.flood = false, false
  path.event("coolant_off", nil, nil, changed)
end)

-- --- Modes of the path ---

word("G90_1", function() core.set_absolute_arc_centers(true) end)
word("G91_1", function() core.set_absolute_arc_centers(false) end)

word("G61", function()
  path.set_mode("exact_path")
end)

word("G61_1", function()
  path.set_mode("exact_stop")
end)

-- P: max deviation at corners; Q: tolerance for merging lines, equal to P if it is missing.
word("G64", function(words)
  for letter, value in pairs(words or {}) do
    if (letter ~= "p" and letter ~= "q") or type(value) ~= "number" then
      alarm("word-out-of-place", "G64 accepts P and Q, the tolerances of the path and of merging lines, not '%s'",
        tostring(letter))
    end
  end
  local tolerance = words and words.p or 0
  local merging = words and words.q or tolerance
  path.set_mode("continuous", math.max(tolerance, 0) * core.unit_mm(), math.max(merging, 0) * core.unit_mm())
  path.warn_of_stops("G64 (continuous mode)")
end)

-- Handles a code that the translator deferred: the surrounding subroutine is called after all.
function env.unknown_code(code)
  alarm("code-unknown", "%s is not a code of RS274/NGC", code)
end

return { check_spindle = check_spindle }
