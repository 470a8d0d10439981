-- RS274/NGC: work coordinate systems 1 to 9 (G54 to G59.3), G52 and G92, and the rotation of a system about
-- Z.
-- machine = rotation * (program + G92) + origin of the system + tool offset
--
-- The parameters #5221.. hold the systems in inches and degrees, #5211.. the G92 offset. As in LinuxCNC,
-- values written into them take effect when a word loads them.

local dialect = use "core/dialect"
local alarm, copied = use("core/basics", "alarm", "copied")
local word = use("core/words", "word")
local axes, compensation, frames, parameters, path, state =
  use "core/axes", use "common/compensation", use "common/frames", dialect.use "variables", use "core/path", use "core/state"

local systems = {}

local FIRST_SYSTEM, PARAMETERS_PER_SYSTEM, ROTATION = 5221, 20, 9
local G92_ACTIVE, FIRST_G92 = 5210, 5211
local ACTIVE_SYSTEM = 5220
local names = { "54", "55", "56", "57", "58", "59", "59.1", "59.2", "59.3" }

function systems.name(number) return names[number] end

-- The word of each system: 59.1 is G59_1.
systems.words = { "G54", "G55", "G56", "G57", "G58", "G59", "G59_1", "G59_2", "G59_3" }

systems.active_system = 1     -- its number
local origin = {}       -- of the system in force, by letter, mm or deg
local rotation_deg = 0  -- of the system in force

local function base(system) return FIRST_SYSTEM + (system - 1) * PARAMETERS_PER_SYSTEM end

-- Returns the origin (by letter, mm and deg) and rotation of a system from its parameters.
function systems.data(system)
  local at = {}
  for i, letter in ipairs(parameters.letters) do
    at[letter] = parameters.from_stored(letter, parameters.values[base(system) + i - 1])
  end
  return at, parameters.values[base(system) + ROTATION]
end

function systems.store_origin(system, letter, value)
  for i, known in ipairs(parameters.letters) do
    if known == letter then parameters.set(base(system) + i - 1, parameters.to_stored(letter, value)) end
  end
end

-- Returns true if a parameter is an origin, or the number of the active system, with which no run begins.
function systems.is_origin(number)
  if number == ACTIVE_SYSTEM then return true end
  local place = number - FIRST_SYSTEM
  return place >= 0 and place < PARAMETERS_PER_SYSTEM * #names and place % PARAMETERS_PER_SYSTEM < ROTATION
end

-- Returns the current offsets of the machine data. Unchanged values are as in the data, without conversion to
-- inches.
function systems.stored_offsets()
  local stored = copied(core.offsets)
  for system, name in ipairs(names) do
    local given, entry, changed = core.offsets[name] or {}, {}, false
    for i, letter in ipairs(parameters.letters) do
      local number = base(system) + i - 1
      local value, before = parameters.values[number], given[letter]
      local same = before and value == parameters.to_stored(letter, before)
      if axes.is_rotary[letter] ~= nil then entry[letter] = same and before or parameters.from_stored(letter, value) end
      changed = changed or parameters.has_changed(number)
    end
    if changed then stored[name] = entry end
  end
  return stored
end

function systems.store_rotation(system, degrees) parameters.set(base(system) + ROTATION, degrees) end

-- Returns X and Y rotated about Z.
function systems.turned(x, y, degrees)
  local c, s = math.cos(math.rad(degrees)), math.sin(math.rad(degrees))
  return x * c - y * s, x * s + y * c
end

-- Returns `point` (program coordinates, mm and deg, all axes) in machine coordinates without the tool offset.
function systems.placed(point, at, degrees, g92)
  local placed = {}
  for letter, value in pairs(point) do placed[letter] = value + (g92[letter] or 0) end
  if placed.x and placed.y then placed.x, placed.y = systems.turned(placed.x, placed.y, degrees) end
  for letter, value in pairs(placed) do placed[letter] = value + (at[letter] or 0) end
  return placed
end

local zero = {}
for _, axis in ipairs(axes.list) do zero[axis.letter] = 0 end

-- Passes the sum of all offsets to the C++ side.
local function apply_offsets()
  local offset = systems.placed(zero, origin, rotation_deg, state.g92)
  for letter, value in pairs(offset) do core.set_offset(letter, value + (state.tool_offset[letter] or 0)) end
  local c, s = math.cos(math.rad(rotation_deg)), math.sin(math.rad(rotation_deg))
  core.set_matrix(rotation_deg ~= 0 and { c, -s, 0, s, c, 0, 0, 0, 1 } or nil)
end

-- The systems of the machine at the beginning of the run.
local at_start = {}

local function save_start_systems()
  for system in ipairs(names) do
    local at, degrees = systems.data(system)
    at_start[system] = { origin = at, rotation_deg = degrees }
  end
end

local function report_system(system)
  local start = at_start[system]
  local at, degrees = systems.data(system)
  local moved = degrees ~= start.rotation_deg
  for letter, value in pairs(at) do moved = moved or value ~= start.origin[letter] end
  core.select_work_offset(names[system], start.origin, start.rotation_deg, moved)
end

-- Activates the system's parameters.
function systems.load(system)
  systems.active_system = system
  parameters.set(ACTIVE_SYSTEM, system)
  origin, rotation_deg = systems.data(system)
  apply_offsets()
  path.act(function() report_system(system) end)
end

for system, name in ipairs(names) do
  word(systems.words[system], function()
    if system ~= systems.active_system then
      path.wait()   -- even if both systems are identical
      systems.load(system)
    end
  end)
end

-- Stores the current G92 offset in its parameters.
local function store_g92()
  for i, letter in ipairs(parameters.letters) do
    parameters.set(FIRST_G92 + i - 1, parameters.to_stored(letter, state.g92[letter] or 0))
  end
  parameters.set(G92_ACTIVE, 1)
  apply_offsets()
end

-- G92: the current position gets the given coordinates.
word("G92", function(words)
  local here = axes.program_position()
  local any = frames.each_axis(words, "G92", "", function(letter, value)
    state.g92[letter] = (state.g92[letter] or 0) + here[letter] - value
  end)
  if not any then alarm("word-missing", "G92 needs axis words") end
  store_g92()
end)

-- G52: the same offset, given directly.
word("G52", function(words)
  if not frames.each_axis(words, "G52", "", function(letter, value) state.g92[letter] = value end) then
    alarm("word-missing", "G52 needs axis words")
  end
  store_g92()
end)

local function clear_g92(name)
  if next(state.g92) ~= nil then compensation.refuse(name) end
  state.g92 = {}
  parameters.set(G92_ACTIVE, 0)
  apply_offsets()
end

word("G92_1", function()
  clear_g92("G92.1")
  for i in ipairs(parameters.letters) do parameters.set(FIRST_G92 + i - 1, 0) end
end)

word("G92_2", function() clear_g92("G92.2") end)

local function load_g92()
  for i, letter in ipairs(parameters.letters) do
    state.g92[letter] = parameters.from_stored(letter, parameters.values[FIRST_G92 + i - 1])
  end
  apply_offsets()
end

-- LinuxCNC ignores it while cutter compensation is on.
word("G92_3", function()
  if compensation.word then
    core.warn("G92.3 has no effect while cutter compensation is on; program G40 first")
    return
  end
  parameters.set(G92_ACTIVE, 1)
  load_g92()
end)

word("G53", function()
  axes.reject_with_tcp_control("G53")
  if core.is_incremental() then alarm("mode", "G53 moves in machine coordinates, which are absolute: it needs G90") end
  core.machine_frame_once()
end)

-- The systems from the machine data.
for system, name in ipairs(names) do
  for letter, value in pairs(core.offsets[name] or {}) do systems.store_origin(system, letter, value) end
end
save_start_systems()
systems.load(1)
if parameters.values[G92_ACTIVE] ~= 0 then load_g92() end   -- kept from the run before

systems.apply_offsets = apply_offsets
return systems
