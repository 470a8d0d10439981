-- RS274/NGC: O-word subroutines. `sub(100, function() ... end)` defines one when the file is loaded,
-- `call(100, 1.5, 2)` calls it with #1 = 1.5 and #2 = 2.

local dialect = use "core/dialect"
local alarm = use("core/basics", "alarm")
local calls, parameters, programs, state = use "core/calls", dialect.use "variables", use "core/programs", use "core/state"

local MAX_ARGUMENTS = 30

local subs = {}   -- { body, place } by number or name

local function sub_key(name)
  if type(name) == "string" then return name:lower() end
  return parameters.whole(name) or alarm("word-value", "the number of a subroutine must be an integer, not %s", tostring(name))
end

local function display_text(key) return type(key) == "string" and ("o<%s>"):format(key) or ("o%d"):format(key) end

function env.sub(name, body)
  local key = sub_key(name)
  core.note_place()
  local place = core.place()
  if subs[key] and subs[key].place ~= place then
    alarm("program-twice", "%s sub is defined twice; first in line %d", display_text(key), subs[key].place & 0xffffffff)
  end
  subs[key] = { body = body, place = place }
end

local function find(key)
  if subs[key] == nil then programs.load_file(key) end
  return subs[key] or alarm("program-missing",
    "%s call: subroutine not found, neither in this file nor in a file next to it", display_text(key))
end

function env.call(name, ...)
  local key = sub_key(name)
  if select("#", ...) > MAX_ARGUMENTS then
    alarm("word-value", "%s call has %d arguments; a subroutine accepts at most %d", display_text(key), select("#", ...),
      MAX_ARGUMENTS)
  end
  local found = find(key)
  core.note_place()
  local frame = calls.enter(display_text(key), { ... })
  state.call_value = nil
  local value = found.body()
  calls.leave(frame)
  state.call_value = type(value) == "number" and value or nil
end

-- Returns the value with which a subroutine ends: `do return result(5) end`.
function env.result(value) return env.number(value) end

-- Returns the passes of o-repeat: the nearest integer, halves to even; 0 passes for values below 0.
function env.times(count)
  if type(count) ~= "number" or count ~= count or math.abs(count) > 2^53 then
    alarm("word-value", "the number of repeats must be a number, not %s", tostring(count))
  end
  local below = math.floor(count)
  local part = count - below
  if part > 0.5 or (part == 0.5 and below % 2 == 1) then below = below + 1 end
  return math.max(0, math.tointeger(below))
end
