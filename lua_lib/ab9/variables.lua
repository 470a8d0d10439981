-- Variables #1.. of the 9/Series as v[1].. A vacant variable is nil.

local dialect = use "core/dialect"
local alarm, copied = use("core/basics", "alarm", "copied")
local release_comment = use("common/expressions", "release_comment")
local system = dialect.use "system"

local LAST_LOCAL, FIRST_COMMON, LAST_COMMON, FIRST_PERMANENT, LAST_PERMANENT = 33, 100, 199, 500, 999

-- Returns the integer that an index means; expressions may miss it by rounding.
local function index(number)
  number = number or 0
  if type(number) ~= "number" or number ~= number then alarm("script", "the number of a variable must be a number") end
  local whole = math.floor(number + 0.5)
  if math.abs(number - whole) > 1e-6 then
    alarm("variable", "unknown variable #%.10g: the number must be an integer", number)
  end
  local exists = whole >= 0 and whole <= LAST_LOCAL
    or whole >= FIRST_COMMON and whole <= LAST_COMMON
    or whole >= FIRST_PERMANENT and whole <= LAST_PERMANENT
  return math.tointeger(whole), exists
end

local function unknown(number)
  alarm("variable", "unknown variable #%d; variables are #1 to #33, #100 to #199, #500 to #999, and %s", number,
    system.NUMBERS)
end

-- A plain table: Lua itself reads and writes existing entries, all others are handled here.
local variables = {}
for number, value in pairs(core.variables) do
  local _, exists = index(number)
  if exists then variables[number] = value end
end
env.v = setmetatable(variables, {
  __index = function(held, number)
    local whole, exists = index(number)
    if exists then return rawget(held, whole) end
    local known, value = system.get(whole)
    if not known then unknown(whole) end
    return value
  end,
  __newindex = function(held, number, value)
    local whole, exists = index(number)
    if whole == 0 then alarm("variable", "#0 is always vacant and cannot be set") end
    local remark = release_comment()
    if exists then
      rawset(held, whole, value)
    elseif not system.set(whole, value, remark) then
      unknown(whole)
    end
  end,
})

-- Returns the variables that the controller keeps from one run to the next.
local function permanent_variables()
  local kept = {}
  for number = FIRST_PERMANENT, LAST_PERMANENT do
    local value = rawget(variables, number)
    if type(value) == "number" then kept[number] = value end
  end
  return kept
end

-- Returns the present variables of the machine data: only those that the controller keeps may have changed
-- permanently.
local function stored_variables()
  local stored = copied(core.variables)
  for number = FIRST_PERMANENT, LAST_PERMANENT do stored[number] = nil end
  for number, value in pairs(permanent_variables()) do stored[number] = value end
  system.store(stored)
  return stored
end

return { permanent = permanent_variables, stored = stored_variables }
