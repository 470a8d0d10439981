-- RS274/NGC: G28 and G30 move to a stored point through an intermediate point, G28.1 and G30.1 store the
-- machine position.

local dialect = use "core/dialect"
local word = use("core/words", "word")
local axes, parameters, path, polar = use "core/axes", dialect.use "variables", use "core/path", use "common/polar"

-- Returns the stored point in machine coordinates, from its parameters (inches and degrees).
local function stored(first)
  local point = {}
  for i, letter in ipairs(parameters.letters) do
    if axes.is_rotary[letter] ~= nil then point[letter] = parameters.from_stored(letter, env.v[first + i - 1]) end
  end
  return point
end

local function store(first, point)
  for i, letter in ipairs(parameters.letters) do
    parameters.set(first + i - 1, parameters.to_stored(letter, point[letter] or 0))
  end
end

-- Only the named axes continue to the stored point, in the directions of the program; all axes if none is
-- named.
local function go(words, first)
  local intermediate, any = axes.programmed_point(), false
  if words ~= nil then intermediate, any = core.target(polar.resolve(words)) end
  path.rapid(intermediate)
  local home = stored(first)
  for letter, value in pairs(home) do home[letter] = core.turned(letter, value) end
  if any then
    local program, home_program = core.to_program(intermediate), core.to_program(home)
    for letter in pairs(polar.resolve(words)) do program[letter] = home_program[letter] end
    home = core.to_machine(program)
  end
  path.rapid(home)
end

local homes = {}
for _, axis in ipairs(axes.list) do homes[axis.letter] = axis.home end

-- At the start, the point is home position `home_number` of the machine, or the first one if it has none.
-- A value kept from the run before has priority.
local function define(name, first, home_number)
  local further = core.homes[home_number] or {}
  for i, letter in ipairs(parameters.letters) do
    local number, home = first + i - 1, further[letter] or homes[letter]
    if home and not core.variables[number] then parameters.set(number, parameters.to_stored(letter, home)) end
  end
  word(name, function(words)
    axes.reject_with_tcp_control(name)
    go(words, first)
  end)
  word(name .. "_1", function()
    axes.reject_with_tcp_control(name .. ".1")
    store(first, axes.display_point(axes.programmed_point()))
  end)
end
define("G28", 5161, 1)
define("G30", 5181, 2)
