-- RS274/NGC: numbered parameters #1 to #5601 as v[1].., and the functions of expressions that differ from
-- variables.lua. An unset parameter is 0. #1 to #30 are local to a subroutine (rs274ngc/subs.lua).

local alarm, copied = use("core/basics", "alarm", "copied")
local axes, hooks = use "core/axes", use "core/hooks"


local LAST = 5601
local INDEX_TOLERANCE = 1e-4   -- for a number that represents an integer
local EQUAL_TOLERANCE = 1e-4   -- of EQ and NE; the other comparisons are exact

local STORED_UNIT_MM = 25.4         -- mm of a unit in the parameters of offsets, home points and tools: inches, as rs274 has them

local parameters = {
  letters = { "x", "y", "z", "a", "b", "c", "u", "v", "w" },   -- axes in the order of their parameters
}

local rotary = { a = true, b = true, c = true }

-- Returns true if a letter means an angle, even if the machine has no such axis.
function parameters.is_angle(letter)
  local known = axes.is_rotary[letter]
  if known == nil then return rotary[letter] or false end
  return known
end

function parameters.to_stored(letter, value) return parameters.is_angle(letter) and value or value / STORED_UNIT_MM end
function parameters.from_stored(letter, value) return parameters.is_angle(letter) and value or value * STORED_UNIT_MM end

-- Returns the integer that a value means, or nil.
function parameters.whole(value)
  if type(value) ~= "number" or value ~= value then return nil end
  local whole = math.tointeger(math.floor(value + 0.5))
  if whole == nil or math.abs(value - whole) > INDEX_TOLERANCE then return nil end
  return whole
end

local function whole_number(number)
  return parameters.whole(number) or alarm("word-value", "the number of a parameter must be an integer, not %s", tostring(number))
end

function parameters.has_number(number)
  local whole = whole_number(number)
  return whole >= 1 and whole <= LAST
end

local function index(number)
  local whole = whole_number(number)
  if whole < 1 or whole > LAST then
    alarm("variable", "unknown parameter #%d; parameters are #1 to #%d", whole, LAST)
  end
  return whole
end

-- Parameters that the controller computes when they are read; they cannot be written.
local computed = {}

function parameters.compute(number, value) computed[number] = value end

local values = {}
parameters.values = setmetatable(values, {
  __index = function(held, number)
    local whole = index(number)
    if computed[whole] then return computed[whole]() + 0.0 end
    return rawget(held, whole) or 0.0
  end,
  __newindex = function(held, number, value)
    local whole = index(number)
    if computed[whole] then alarm("variable", "#%d is read-only: the controller sets it", whole) end
    rawset(held, whole, value)
  end,
})
env.v = values

-- Values from the machine data or the file of permanent variables.
for number, value in pairs(core.variables) do
  if number > 30 and number <= LAST then values[number] = value + 0.0 end
end

-- Returns the values that LinuxCNC keeps from one run to the next: those from the start, home points and
-- offsets.
local FIRST_PERMANENT, LAST_PERMANENT = 5161, 5390
function parameters.permanent()
  local kept = {}
  for number in pairs(core.variables) do kept[number] = rawget(values, number) end
  for number = FIRST_PERMANENT, LAST_PERMANENT do
    local value = rawget(values, number)
    if value and value ~= 0 then kept[number] = value end
  end
  return kept
end

-- Parameters at the beginning of the run.
local at_start = {}
hooks.on("begin", "numbered parameters", function()
  for number, value in pairs(values) do at_start[number] = value end
end)
function parameters.has_changed(number) return rawget(values, number) ~= at_start[number] end

-- Returns the current variables of the machine data, and the kept parameters that the run has changed.
-- Origins of the systems are not included: they are offsets.
function parameters.stored(is_origin)
  local stored = copied(core.variables)
  for number in pairs(stored) do
    if number > 30 and number <= LAST then stored[number] = rawget(values, number) end
  end
  for number = FIRST_PERMANENT, LAST_PERMANENT do
    if parameters.has_changed(number) and not is_origin(number) then stored[number] = rawget(values, number) end
  end
  return stored
end

-- Sets a parameter for the controller itself, without the checks.
function parameters.set(number, value) rawset(values, number, value + 0.0) end

-- #1 to #30 always have values, so reading and writing them here is plain and fast.
local LAST_LOCAL = 30
for i = 1, LAST_LOCAL do values[i] = 0.0 end

-- Gives them new values, 0 if none is given, and returns the old ones.
local function swap_locals(new)
  local old = {}
  for i = 1, LAST_LOCAL do
    old[i], values[i] = values[i], new[i] or 0.0
  end
  return old
end

-- A call with arguments has its own local parameters; without arguments those of the caller remain active, as
-- for M98.
hooks.on("call", "numbered parameters", function(frame, arguments)
  frame.numbered = arguments and swap_locals(arguments)
end)
hooks.on("return", "numbered parameters", function(frame)
  if frame.numbered then swap_locals(frame.numbered) end
end)

values[5599] = 1.0   -- debug messages are shown

-- Expressions. A comparison is allowed if a number is expected.
local function number_of(value)
  if value == true then return 1 end
  if not value then return 0 end
  if type(value) ~= "number" then alarm("script", "an expression has a value that is not a number") end
  return value
end

local function finite(value, what)
  if value ~= value or value == math.huge or value == -math.huge then
    alarm("arithmetic", "%s has no finite value", what)
  end
  return value + 0.0
end

function env.truth(value) return number_of(value) ~= 0 end
function env.number(condition) return number_of(condition) + 0.0 end

function env.equal(a, b) return math.abs(number_of(a) - number_of(b)) <= EQUAL_TOLERANCE end

local function logical(value) return value and 1.0 or 0.0 end
function env.AND(a, b) return logical(number_of(a) ~= 0 and number_of(b) ~= 0) end
function env.OR(a, b) return logical(number_of(a) ~= 0 or number_of(b) ~= 0) end
function env.XOR(a, b) return logical((number_of(a) ~= 0) ~= (number_of(b) ~= 0)) end

-- Returns a value from 0 to below the absolute value of b, for any signs.
function env.MOD(a, b)
  a, b = number_of(a), math.abs(number_of(b))
  if b == 0 then alarm("arithmetic", "MOD by zero") end
  return finite(a % b, "MOD")
end

function env.POW(a, b)
  a, b = number_of(a), number_of(b)
  if a < 0 and b % 1 ~= 0 then alarm("arithmetic", "%.10g ** %.10g: a negative number needs an integer exponent", a, b) end
  return finite(a ^ b, ("%.10g ** %.10g"):format(a, b))
end

function env.EXP(a) return finite(math.exp(number_of(a)), "EXP") end

-- Returns the angle of the point (b, a), from -180 to 180.
function env.ATAN(a, b)
  if b == nil then alarm("arithmetic", "ATAN needs two sides: ATAN[1]/[2]") end
  return core.atan_deg(number_of(a), number_of(b))
end

function env.FIX(a) return math.floor(number_of(a)) + 0.0 end
function env.FUP(a) return math.ceil(number_of(a)) + 0.0 end

-- BIN and BCD belong to other dialects.
local function unknown(name)
  return function() alarm("syntax", "%s is not a function of RS274/NGC", name) end
end
env.BIN, env.BCD = unknown("BIN"), unknown("BCD")

return parameters
