-- The modal state of the control, and how words are defined.

state = {
  plane = "xy",
  incremental = false,
  unit_mm = core.unit_mm_at_start,   -- mm of one program unit on a linear axis
  frame = "54",         -- work coordinate system in force
  g52 = {}, g92 = {},   -- offsets by axis letter, mm or deg
  polar = false,
  motion = "G0",        -- the modal motion: G0, G1, G2, G3 or CIP
  feed_mode = "minute", -- or "inverse", "revolution"
  spindle_rpm = 0,
  arc_absolute = false, -- centres of arcs are points, not vectors from the start
  has_matrix = false,   -- core.set_matrix() is in force: rotation, scaling or mirror image
  tool_offset = {},     -- by axis letter, mm
  depth = 0,            -- of subprograms
}

axes = core.axes()
is_rotary = {}
for _, axis in ipairs(axes) do is_rotary[axis.letter] = axis.rotary end

local function point_of(position)
  local point = {}
  for _, axis in ipairs(axes) do point[axis.letter] = position(axis.letter) end
  return point
end

-- Where the program stands and where the machine stands, in machine coordinates of all axes. They differ while a filter
-- of the path moves or holds back moves.
function programmed_point() return point_of(core.position) end
function machine_point() return point_of(core.machine_position) end

local unwinding = {}
for _, axis in ipairs(axes) do
  if axis.unwinds then unwinding[#unwinding + 1] = axis.letter end
end

-- A point as the control shows it: axes that unwind show no whole turns.
function shown(point)
  for _, letter in ipairs(unwinding) do point[letter] = core.reading(letter, point[letter]) end
  return point
end

-- The program coordinates of the programmed point, in mm and deg.
function program_position()
  return core.to_program(#unwinding > 0 and shown(programmed_point()) or {})
end

-- The value of an axis in mm or deg, and in program units.
function in_mm(letter, value) return is_rotary[letter] and value or value * state.unit_mm end
function in_program_units(letter, value) return is_rotary[letter] and value or value / state.unit_mm end

-- The direction of a program axis in the machine; with scaling its length is the factor.
function axis_direction(letter)
  local x, y, z = core.direction(letter == "x" and 1 or 0, letter == "y" and 1 or 0, letter == "z" and 1 or 0)
  return { x = x, y = y, z = z }
end

-- Distance of two points in space; axes that the machine does not have count as 0.
function space_between(a, b)
  local sum = 0
  for _, letter in ipairs { "x", "y", "z" } do sum = sum + ((b[letter] or 0) - (a[letter] or 0)) ^ 2 end
  return math.sqrt(sum)
end

-- RS274/NGC: a number within 0.0001 of a whole one counts as it, as in LinuxCNC; elsewhere it must be exact.
function nearly_whole(value)
  if core.dialect ~= "rs274ngc" or type(value) ~= "number" then return value end
  local near = math.floor(value + 0.5)
  return math.abs(value - near) <= 1e-4 and near or value
end

local next_id = 0

function word_id()
  next_id = next_id + 1
  return next_id - 1
end

-- The rule of the word under way, where the control has one of its own for it.
stop_rule = nil

-- A word as it is printed: G92_1 is G92.1.
local function printed(name)
  local at = name:find("_", 1, true)
  return at and name:sub(1, at - 1) .. "." .. name:sub(at + 1) or name
end

-- The meaning of a word at which the control waits by a rule of its own (core.stops, docs/stops.md).
local function by_stop_rule(name, meaning)
  local rule = core.stops[printed(name)]
  if rule == nil then return meaning end
  return function(...)
    local outer = stop_rule
    stop_rule = rule
    if rule == "always" then path.wait() end
    local result = meaning(...)
    stop_rule = outer
    return result
  end
end

-- Defines a word of the language. A call counts as part of a block at the line where the script makes it.
function word(name, meaning)
  env[name] = core.word(word_id(), with_known_keys(name, by_stop_rule(name, meaning)))
end

-- Ends the run. `kind` is the code of a kind of diagnostic (base/text/diagnostic_kind.cpp); the text and its values are as
-- for string.format.
function alarm(kind, text, ...)
  core.alarm(kind, text:format(...))
end

function copied(values)
  local copy = {}
  for key, value in unordered(values) do copy[key] = value end
  return copy
end

-- The words of a move, in a table by their letters; nil counts as none.
function check_table(words, name)
  if words ~= nil and type(words) ~= "table" then
    alarm("script", "%s takes its words in braces: %s{x=1, y=2}", name, name)
  end
end

-- The value of a word that stands alone: nil is a vacant variable, and the word counts as left out.
function given(value, name)
  if value ~= nil and type(value) ~= "number" then alarm("script", "%s takes a number", name) end
  return value ~= nil
end
