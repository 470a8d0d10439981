-- Axes of the machine, and their positions.

local alarm = use("core/basics", "alarm")

local axes = { list = core.axes(), is_rotary = {} }
local is_rotary = axes.is_rotary
for _, axis in ipairs(axes.list) do is_rotary[axis.letter] = axis.rotary end

local function to_point(position)
  local point = {}
  for _, axis in ipairs(axes.list) do point[axis.letter] = position(axis.letter) end
  return point
end

-- Return the position of the program and that of the machine, in machine coordinates of all axes. They differ
-- while a filter of the path shifts or buffers moves.
function axes.programmed_point() return to_point(core.position) end
function axes.machine_point() return to_point(core.machine_position) end

local unwinding = {}
for _, axis in ipairs(axes.list) do
  if axis.unwinds then unwinding[#unwinding + 1] = axis.letter end
end

-- Returns a point as the controller displays it: axes that unwind show no full turns.
function axes.display_point(point)
  for _, letter in ipairs(unwinding) do point[letter] = core.reading(letter, point[letter]) end
  return point
end

-- Returns the program coordinates of the programmed point, in mm and deg.
function axes.program_position()
  return core.to_program(#unwinding > 0 and axes.display_point(axes.programmed_point()) or {})
end

-- Returns the value of an axis word in program units, which the word may count with another factor
-- (core.set_word_factor).
function axes.word_in_units(letter, value)
  return is_rotary[letter] ~= nil and value * core.word_factor(letter) or value
end

-- Return the value of an axis in mm or deg, and in program units.
function axes.in_mm(letter, value) return is_rotary[letter] and value or value * core.unit_mm() end
function axes.in_program_units(letter, value) return is_rotary[letter] and value or value / core.unit_mm() end

-- Returns the direction of a program axis in the machine; with scaling its length is the factor.
function axes.direction(letter)
  local x, y, z = core.direction(letter == "x" and 1 or 0, letter == "y" and 1 or 0, letter == "z" and 1 or 0)
  return { x = x, y = y, z = z }
end

-- Raises an alarm for words that mean positions of the axes themselves.
function axes.reject_with_tcp_control(what)
  if core.tip_control() then
    alarm("mode", "%s cannot be used with G43.4, in which X, Y and Z are the TCP; G49 ends it", what)
  end
end

return axes
