-- Work coordinate systems, offsets, units, and absolute or incremental dimensions.
-- machine = transform(program value * unit) + frame + G52 + G92 + tool offset

local function frame_offset(letter)
  local frame = core.offsets[state.frame]
  return frame and frame[letter] or 0
end

local shift = {}   -- of the transform, by letter

-- Hands the sum of all offsets to the C++ side.
function apply_offsets()
  for _, axis in ipairs(axes) do
    local letter = axis.letter
    core.set_offset(letter, frame_offset(letter) + (state.g52[letter] or 0) + (state.g92[letter] or 0)
      + (state.tool_offset[letter] or 0) + (shift[letter] or 0))
  end
end
local apply = apply_offsets

-- Rotation, scaling and mirror image: p' = m * p + by, before the offsets; m is nine numbers row by row, or nil.
function set_transform(m, by)
  core.set_matrix(m)
  state.has_matrix = m ~= nil
  shift = by or {}
  apply()
end

local function select_frame(code)
  return function()
    state.frame = code
    apply()
  end
end

for code = 54, 59 do word("G" .. code, select_frame(tostring(code))) end
for part = 1, 3 do word("G59_" .. part, select_frame("59." .. part)) end
for code = 505, 599 do word("G" .. code, select_frame(tostring(code))) end

local function length(letter, value)
  return is_rotary[letter] and value or value * state.unit_mm
end

-- Calls set(letter, value in mm or deg) for each axis word.
local function each_axis(words, name, set)
  if type(words) ~= "table" then alarm("%s needs axis words", name) end
  for letter, value in pairs(words) do
    if type(value) ~= "number" then alarm("%s: the value of '%s' is no number", name, tostring(letter)) end
    if is_rotary[letter] == nil then alarm("%s: the machine has no axis %s", name, tostring(letter):upper()) end
    set(letter, length(letter, value))
  end
end

-- G92: where the machine stands gets the given coordinates.
word("G92", function(words)
  local program = core.to_program {}
  local move = {}
  each_axis(words, "G92", function(letter, value) move[letter] = program[letter] - value end)
  local space = {}
  space.x, space.y, space.z = core.direction(move.x, move.y, move.z)
  for letter in pairs(is_rotary) do
    state.g92[letter] = (state.g92[letter] or 0) + (space[letter] or move[letter] or 0)
  end
  apply()
end)

word("G92_1", function()
  state.g92 = {}
  apply()
end)

-- G52: the zero point moves by the given distances, measured from the work coordinate system.
word("G52", function(words)
  each_axis(words, "G52", function(letter, value) state.g52[letter] = value end)
  apply()
end)

-- G53: this block moves in machine coordinates, absolute.
word("G53", core.machine_frame_once)

local function set_unit(millimetres)
  return function()
    state.unit_mm = millimetres
    core.set_unit(millimetres)
  end
end
word("G20", set_unit(25.4))
word("G21", set_unit(1))

local function set_incremental(on)
  return function()
    state.incremental = on
    core.set_incremental(on)
  end
end
word("G90", set_incremental(false))
word("G91", set_incremental(true))

word("G17", function() state.plane = "xy" end)
word("G18", function() state.plane = "zx" end)
word("G19", function() state.plane = "yz" end)

apply()
