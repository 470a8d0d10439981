-- Variables #1.. as v[1].., and the functions of expressions. A vacant variable is nil and counts as 0.

local LAST_LOCAL, FIRST_COMMON, LAST_COMMON, FIRST_PERMANENT, LAST_PERMANENT = 33, 100, 199, 500, 999

-- The whole number that an index means; expressions may miss it by rounding.
local function index(number)
  number = number or 0
  if type(number) ~= "number" or number ~= number then alarm("script", "the number of a variable is no number") end
  local whole = math.floor(number + 0.5)
  if math.abs(number - whole) > 1e-6 then
    alarm("variable", "there is no variable #%.10g: the number is not whole", number)
  end
  local exists = whole >= 0 and whole <= LAST_LOCAL
    or whole >= FIRST_COMMON and whole <= LAST_COMMON
    or whole >= FIRST_PERMANENT and whole <= LAST_PERMANENT
  return math.tointeger(whole), exists
end

local function unknown(number)
  alarm("variable", "there is no variable #%d; there are #1 to #33, #100 to #199, #500 to #999, and %s", number,
    system_variables())
end

-- A text for the system variable that is set next: the remark of its block (#3000, #3006).
local text
function env.message(remark) text = remark end

-- A plain table: what exists is read and written by Lua itself, the rest comes here.
local variables = {}
for number, value in pairs(core.variables) do
  local _, exists = index(number)
  if exists then variables[number] = value end
end
env.v = setmetatable(variables, {
  __index = function(held, number)
    local whole, exists = index(number)
    if exists then return rawget(held, whole) end
    local known, value = system_variable_get(whole)
    if not known then unknown(whole) end
    return value
  end,
  __newindex = function(held, number, value)
    local whole, exists = index(number)
    if whole == 0 then alarm("variable", "#0 is always vacant; nothing can be put into it") end
    local remark = text
    text = nil
    if exists then
      rawset(held, whole, value)
    elseif not system_variable_set(whole, value, remark) then
      unknown(whole)
    end
  end,
})

-- What the control keeps from one run to the next.
function permanent_variables()
  local kept = {}
  for number = FIRST_PERMANENT, LAST_PERMANENT do
    local value = rawget(variables, number)
    if type(value) == "number" then kept[number] = value end
  end
  return kept
end

-- The variables of the machine data as they are now: only those that the control keeps may have changed for good.
function stored_variables()
  local stored = copied(core.variables)
  for number = FIRST_PERMANENT, LAST_PERMANENT do stored[number] = nil end
  for number, value in pairs(permanent_variables()) do stored[number] = value end
  return stored
end

local function number_of(value)
  if value == nil then return 0 end
  if type(value) ~= "number" then alarm("script", "an expression has a value that is no number") end
  return value
end

local function rounded(value)
  value = number_of(value)
  return value < 0 and math.ceil(value - 0.5) or math.floor(value + 0.5)
end

-- AND, OR and XOR work on whole numbers.
local function bits(value)
  local whole = rounded(value)
  return math.tointeger(whole) or alarm("arithmetic", "%.10g is too large for AND, OR and XOR", whole)
end

local function in_domain(name, value, ok)
  if not ok then alarm("arithmetic", "%s of %.10g has no value", name, value) end
end

function env.div(a, b)
  a, b = number_of(a), number_of(b)
  if b == 0 then alarm("arithmetic", "division by zero") end
  return a / b
end

function env.MOD(a, b)
  a, b = number_of(a), number_of(b)
  if b == 0 then alarm("arithmetic", "MOD by zero") end
  return a - b * math.floor(a / b)
end

function env.AND(a, b) return (bits(a) & bits(b)) + 0.0 end
function env.OR(a, b) return (bits(a) | bits(b)) + 0.0 end
function env.XOR(a, b) return (bits(a) ~ bits(b)) + 0.0 end

-- Angles are in degrees.
function env.SIN(a) return core.sin_deg(number_of(a)) end
function env.COS(a) return core.cos_deg(number_of(a)) end
function env.TAN(a) return core.tan_deg(number_of(a)) end

function env.ASIN(a)
  a = number_of(a)
  in_domain("ASIN", a, a >= -1 and a <= 1)
  return core.asin_deg(a)
end

function env.ACOS(a)
  a = number_of(a)
  in_domain("ACOS", a, a >= -1 and a <= 1)
  return core.acos_deg(a)
end

-- One side: -90 to 90; two sides (ATAN[a]/[b]): the angle of the point (b, a), 0 to 360.
function env.ATAN(a, b)
  if b == nil then return core.atan_deg(number_of(a)) end
  local angle = core.atan_deg(number_of(a), number_of(b))
  return angle < 0 and angle + 360 or angle
end

function env.SQRT(a)
  a = number_of(a)
  in_domain("SQRT", a, a >= 0)
  return math.sqrt(a)
end

function env.LN(a)
  a = number_of(a)
  in_domain("LN", a, a > 0)
  return math.log(a)
end

function env.EXP(a) return math.exp(number_of(a)) end
function env.ABS(a) return math.abs(number_of(a)) end
function env.ROUND(a) return rounded(a) + 0.0 end
function env.FIX(a) a = number_of(a) return (a < 0 and math.ceil(a) or math.floor(a)) + 0.0 end
function env.FUP(a) a = number_of(a) return (a < 0 and math.floor(a) or math.ceil(a)) + 0.0 end

-- BIN reads each four bits as a decimal digit, BCD is its inverse.
local function digits(value, from, to)
  local rest, result, weight = bits(value), 0, 1
  if rest < 0 then alarm("arithmetic", "BIN and BCD take numbers from 0 on") end
  while rest > 0 do
    result = result + (rest % from) * weight
    rest, weight = rest // from, weight * to
  end
  return result + 0.0
end
function env.BIN(a) return digits(a, 16, 10) end
function env.BCD(a) return digits(a, 10, 16) end

-- A number as a condition, and a condition as a number.
function env.truth(value) return number_of(value) ~= 0 end
function env.number(condition) return condition and 1.0 or 0.0 end

function env.goto_target(value)
  core.note_place()
  local whole = rounded(value)
  if math.abs(number_of(value) - whole) > 1e-6 then alarm("jump", "GOTO %.10g: a block number is whole", value) end
  return whole
end

-- Stands at the end of the program; the place is that of the GOTO.
function env.no_target(number)
  core.alarm_at_noted_place("jump", ("GOTO %.10g: no block of this program has that number "
    .. "(a computed GOTO does not lead into loops from outside)"):format(number))
end

-- Block delete: /n is skipped where the operator has switched block delete on.
function env.skipped() return core.block_delete end
