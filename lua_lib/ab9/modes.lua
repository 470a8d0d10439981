-- Modes of the path and the spindle, and switches that only the machine itself knows.

local alarm, given = use("core/basics", "alarm", "given")
local word = use("core/words", "word")
local axes, comp_override, overrides, path, spindle, state =
  use "core/axes", use "common/comp_override", use "common/overrides", use "core/path", use "common/spindle", use "core/state"

local function warn_of_corner_override()
  if comp_override.is_set() then
    path.warn_of_stops("G62 (automatic corner override)")
  else
    core.warn("G62 (automatic corner override): the feed is not reduced at inside corners, because the machine file sets no "
      .. "corner_override_percent with corner_override_before_mm or corner_override_after_mm ([controller])")
  end
end

local function mode(name, number, path_name)
  word(name, function()
    state.path_mode = number
    path.set_mode(path_name)
    overrides.lock("G63", { feed = number == 63 })
    if number == 64 then path.warn_of_stops("G64 (cutting mode)") end
    if number == 62 then warn_of_corner_override() end
  end)
end
mode("G61", 61, "exact_stop")
mode("G62", 62, "continuous")
mode("G63", 63, "continuous")   -- tapping mode: the feed override has no effect
mode("G64", 64, "continuous")
-- One block that ends in an exact stop.
word("G9", function() path.act(core.exact_stop_once) end)

-- --- Feed ---

word("F", function(value)
  if given(value, "F") then core.set_feed(value) end
end)

for name, feed_mode in pairs { G93 = "inverse", G94 = "minute", G95 = "revolution" } do
  word(name, function() core.set_feed_mode(feed_mode) end)
end

-- --- Spindle ---

-- Spindle: G97 S is its speed in rev/min. G96 S is the speed of the surface in m/min (ft/min in inch mode) at
-- the radius X, counted from the zero point of the program. A move has the speed for the middle of its path
-- along X. So a facing cut in feed per revolution takes its true time.

local MM_IN_M, MM_IN_FOOT = 1000, 304.8
local MIN_RADIUS_MM = 1e-3

local limit_rpm = math.huge
local surface_mm_min   -- nil: G97
local is_constant_surface_speed = false

local function turn(rpm) spindle.set_speed(math.min(rpm, limit_rpm)) end

local function rpm_at(radius_mm)
  if radius_mm < MIN_RADIUS_MM and limit_rpm == math.huge then
    alarm("spindle", "G96: at X0 the spindle speed would be unlimited; give the limit with G50 S (rev/min)")
  end
  return surface_mm_min / (2 * math.pi * math.max(radius_mm, MIN_RADIUS_MM))
end

-- Sets the spindle speed for the middle of a move to the target, before the move.
local function adapt(target)
  if surface_mm_min == nil then return end
  local from, to = axes.program_position().x, core.to_program(target).x
  turn(rpm_at(math.abs(from + to) / 2))
end

local function set_constant_surface_speed(on)
  if on == is_constant_surface_speed then return end
  is_constant_surface_speed = on
  if not on then surface_mm_min = nil end
  path.before_feed_moves(on and adapt or nil)
end

word("G96", function()
  if axes.is_rotary.x ~= false then alarm("word-missing", "G96 requires the axis X, whose position is the radius") end
  set_constant_surface_speed(true)
end)

word("G97", function() set_constant_surface_speed(false) end)

local function speed(value, name)
  if not (value >= 0 and value < math.huge) then
    alarm("word-value", "%s must be a speed of 0 or greater, not %.10g", name, value)
  end
  return value
end

word("S", function(value)
  if not given(value, "S") then return end
  local before = core.spindle_rpm()
  if is_constant_surface_speed then
    surface_mm_min = speed(value, "S") * (core.unit_mm() == 1 and MM_IN_M or MM_IN_FOOT)
  else
    turn(speed(value, "S"))
  end
  if state.spindle then path.wait_for(core.spindle_rpm() ~= before) end
end)

word("G50", function(words)
  if words == nil or words.s == nil then
    alarm("mode", "G50 sets the limit of the spindle speed: G50 S2000; G14.1 with P starts scaling, and without P ends it")
  end
  for key in pairs(words) do
    if key ~= "s" then alarm("word-out-of-place", "G50 accepts only S, not %s", tostring(key):upper()) end
  end
  if type(words.s) ~= "number" then alarm("script", "S of G50 is not a number") end
  limit_rpm = speed(words.s, "S of G50")
  if not is_constant_surface_speed then turn(core.spindle_rpm()) end
end)

word("M3", function() spindle.turn("cw") end)
word("M4", function() spindle.turn("ccw") end)
word("M5", function() spindle.turn(nil) end)

-- --- Events of the machine ---

word("M7", function()
  local changed = not state.mist
  state.mist = true
  path.event("coolant_2_on", nil, nil, changed)
end)

-- If the machine file does not define what switches the process ([process]), this is a waterjet.
local function jet(on)
  if core.process == nil then return function() core.set_process(on, false) end end
end
local jet_on, jet_off = jet(true), jet(false)

word("M8", function()
  local changed = not state.flood
  state.flood = true
  if jet_on then path.act(jet_on) end
  path.event("jet_on", nil, nil, changed)
end)

word("M9", function()
  local changed = state.flood or state.mist or false
  state.flood, state.mist = false, false
  if jet_off then path.act(jet_off) end
  path.event("jet_off", nil, nil, changed)
end)

-- M49 locks all overrides of the operator, until M48.
local function override_switch(name, kind, is_locked)
  word(name, function()
    path.event(kind)
    overrides.lock("M49", { feed = is_locked, rapid = is_locked, spindle = is_locked })
  end)
end
override_switch("M48", "overrides_on", false)
override_switch("M49", "overrides_off", true)

-- The spindle stops at its marked angle.
word("M19", function()
  state.spindle = nil
  path.event("spindle_orient")
end)
