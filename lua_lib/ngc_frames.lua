-- RS274/NGC: work coordinate systems 1 to 9 (G54 to G59.3), G52 and G92, and the rotation of a system about Z.
-- machine = rotation * (program + G92) + origin of the system + tool offset
--
-- The parameters #5221.. hold the systems in inches and degrees, #5211.. the G92 offset. As in LinuxCNC, what is
-- written into them takes effect when a word loads them.

local FIRST_SYSTEM, PER_SYSTEM, ROTATION = 5221, 20, 9
local G92_IN_FORCE, FIRST_G92 = 5210, 5211
local NUMBER_OF_SYSTEM = 5220
local names = { "54", "55", "56", "57", "58", "59", "59.1", "59.2", "59.3" }

function ngc.system_name(number) return names[number] end

-- The word of a system: 59.1 is G59_1.
function ngc.system_word(number)
  local name = names[number]
  local dot = name:find(".", 1, true)
  return "G" .. (dot and name:sub(1, dot - 1) .. "_" .. name:sub(dot + 1) or name)
end

ngc.system = 1          -- in force
local origin = {}       -- of the system in force, by letter, mm or deg
local rotation_deg = 0  -- of the system in force
state.g92 = {}          -- in the directions of the system, mm or deg

local function base(system) return FIRST_SYSTEM + (system - 1) * PER_SYSTEM end

-- Origin (by letter, mm and deg) and rotation of a system as its parameters have them.
function ngc.system_data(system)
  local at = {}
  for i, letter in ipairs(ngc.letters) do at[letter] = ngc.from_stored(letter, env.v[base(system) + i - 1]) end
  return at, env.v[base(system) + ROTATION]
end

function ngc.store_origin(system, letter, value)
  for i, known in ipairs(ngc.letters) do
    if known == letter then ngc.set_parameter(base(system) + i - 1, ngc.to_stored(letter, value)) end
  end
end

-- Whether a parameter is an origin, or the number of the system in force, with which no run begins.
function ngc.is_origin(number)
  if number == NUMBER_OF_SYSTEM then return true end
  local place = number - FIRST_SYSTEM
  return place >= 0 and place < PER_SYSTEM * #names and place % PER_SYSTEM < ROTATION
end

-- The offsets of machine data as they are now. Values that have not changed are as the data have them, not by way of
-- inches.
function ngc.stored_offsets()
  local stored = copied(core.offsets)
  for system, name in ipairs(names) do
    local given, entry, changed = core.offsets[name] or {}, {}, false
    for i, letter in ipairs(ngc.letters) do
      local number = base(system) + i - 1
      local value, before = env.v[number], given[letter]
      local same = before and value == ngc.to_stored(letter, before)
      if is_rotary[letter] ~= nil then entry[letter] = same and before or ngc.from_stored(letter, value) end
      changed = changed or ngc.has_changed(number)
    end
    if changed then stored[name] = entry end
  end
  return stored
end

function ngc.store_rotation(system, degrees) ngc.set_parameter(base(system) + ROTATION, degrees) end

-- X and Y turned about Z.
function ngc.turned(x, y, degrees)
  local c, s = math.cos(math.rad(degrees)), math.sin(math.rad(degrees))
  return x * c - y * s, x * s + y * c
end

-- Where `point` (program coordinates, mm and deg, all axes) lies in machine coordinates without the tool offset.
function ngc.placed(point, at, degrees, g92)
  local placed = {}
  for letter, value in pairs(point) do placed[letter] = value + (g92[letter] or 0) end
  if placed.x and placed.y then placed.x, placed.y = ngc.turned(placed.x, placed.y, degrees) end
  for letter, value in pairs(placed) do placed[letter] = value + (at[letter] or 0) end
  return placed
end

local zero = {}
for _, axis in ipairs(axes) do zero[axis.letter] = 0 end

-- Hands the sum of all offsets to the C++ side.
function apply_offsets()
  local offset = ngc.placed(zero, origin, rotation_deg, state.g92)
  for letter, value in pairs(offset) do core.set_offset(letter, value + (state.tool_offset[letter] or 0)) end
  local c, s = math.cos(math.rad(rotation_deg)), math.sin(math.rad(rotation_deg))
  state.has_matrix = rotation_deg ~= 0
  core.set_matrix(state.has_matrix and { c, -s, 0, s, c, 0, 0, 0, 1 } or nil)
end

-- The systems as the machine had them when the run began.
local at_start = {}

local function keep_systems()
  for system in ipairs(names) do
    local at, degrees = ngc.system_data(system)
    at_start[system] = { origin = at, rotation_deg = degrees }
  end
end

local function tell_system(system)
  core.select_work_offset(names[system], at_start[system].origin, at_start[system].rotation_deg)
end

-- The system's parameters come into force.
function ngc.load_system(system)
  ngc.system = system
  ngc.set_parameter(NUMBER_OF_SYSTEM, system)
  origin, rotation_deg = ngc.system_data(system)
  apply_offsets()
  path.act(function() tell_system(system) end)
end

for system, name in ipairs(names) do
  word(ngc.system_word(system), function()
    refuse_with_compensation("G" .. name)
    if system ~= ngc.system then
      path.wait()   -- also where both systems are in one place
      ngc.load_system(system)
    end
  end)
end

-- 0 for an axis that the machine does not have changes nothing.
function no_axis(letter, value, name)
  for _, known in ipairs(ngc.letters) do
    if letter == known then
      if value == 0 then return end
      alarm("axis", "%s: the machine has no axis %s", name, letter:upper())
    end
  end
  alarm("word-out-of-place", "%s takes no word '%s'", name, tostring(letter))
end

-- The G92 offset as it is goes into its parameters.
local function keep_g92()
  for i, letter in ipairs(ngc.letters) do
    ngc.set_parameter(FIRST_G92 + i - 1, ngc.to_stored(letter, state.g92[letter] or 0))
  end
  ngc.set_parameter(G92_IN_FORCE, 1)
  apply_offsets()
end

-- G92: where the program stands gets the given coordinates.
word("G92", function(words)
  refuse_with_compensation("G92")
  local here = program_position()
  local any = each_axis(words, "G92", "", function(letter, value)
    state.g92[letter] = (state.g92[letter] or 0) + here[letter] - value
  end)
  if not any then alarm("word-missing", "G92 needs axis words") end
  keep_g92()
end)

-- G52: the same offset, given as itself.
word("G52", function(words)
  refuse_with_compensation("G52")
  if not each_axis(words, "G52", "", function(letter, value) state.g92[letter] = value end) then
    alarm("word-missing", "G52 needs axis words")
  end
  keep_g92()
end)

local function drop_g92(name)
  if next(state.g92) ~= nil then refuse_with_compensation(name) end
  state.g92 = {}
  ngc.set_parameter(G92_IN_FORCE, 0)
  apply_offsets()
end

word("G92_1", function()
  drop_g92("G92.1")
  for i in ipairs(ngc.letters) do ngc.set_parameter(FIRST_G92 + i - 1, 0) end
end)

word("G92_2", function() drop_g92("G92.2") end)

local function load_g92()
  for i, letter in ipairs(ngc.letters) do
    state.g92[letter] = ngc.from_stored(letter, env.v[FIRST_G92 + i - 1])
  end
  apply_offsets()
end

-- LinuxCNC passes over it while cutter compensation is on.
word("G92_3", function()
  if state.compensation then
    core.warn("G92.3 does nothing while cutter compensation is on; G40 first")
    return
  end
  ngc.set_parameter(G92_IN_FORCE, 1)
  load_g92()
end)

word("G53", function()
  refuse_with_compensation("G53")
  refuse_with_tip_control("G53")
  if state.incremental then alarm("mode", "G53 moves in machine coordinates, which are absolute: it needs G90") end
  core.machine_frame_once()
end)

-- What the machine data say of the systems.
for system, name in ipairs(names) do
  for letter, value in pairs(core.offsets[name] or {}) do ngc.store_origin(system, letter, value) end
end
keep_systems()
ngc.load_system(1)
if env.v[G92_IN_FORCE] ~= 0 then load_g92() end   -- kept from the run before
