-- User M codes: a script, or the machine data, defines `M[101] = function(words) ... end`; a program calls it by its
-- number.

local alarm, check_table = use("core/basics", "alarm", "check_table")
local words = use "core/words"

local LAST = 999

local defined = {}
local ids = {}   -- word id by number: a code that is redefined keeps its id

local function nothing() end

local function undefined(number)
  return function()
    alarm("code-unknown",
      "M%s is not defined on this machine; define it before the program runs: M[%s] = function(words) ... end",
      tostring(number), tostring(number))
  end
end

local function check(number, meaning)
  local whole = math.tointeger(number)
  if whole == nil or whole < 0 or whole > LAST then
    alarm("script", "M[%s]: the number of an M code must be an integer from 0 to %d", tostring(number), LAST)
  end
  if words.is_known("M" .. whole) then
    alarm("script", "M[%d]: M%d is a code of the controller itself", whole, whole)
  end
  if meaning ~= nil and type(meaning) ~= "function" then
    alarm("script", "M[%d] needs a function: M[%d] = function(words) ... end", whole, whole)
  end
  return whole
end

local function make_word(whole, meaning)
  local hooked   -- made at the first call: by then all hooks are known
  ids[whole] = ids[whole] or words.id()
  defined[whole] = core.word(ids[whole], function(given)
    check_table(given, ("M[%d]"):format(whole))
    hooked = hooked or words.with_hooks("M" .. whole, meaning)
    return hooked(given or {})
  end)
  return defined[whole]
end

-- Returns only the hooks before and after a code that is not defined.
local function hooks_only(number)
  local whole = math.tointeger(number)
  return whole and words.is_hooked("M" .. whole) and make_word(whole, nothing) or undefined(number)
end

local function define(number, meaning)
  local whole = check(number, meaning)
  defined[whole] = meaning and make_word(whole, meaning)
end

local M = setmetatable({}, {
  __index = function(_, number) return defined[number] or hooks_only(number) end,
  __newindex = function(_, number, meaning) define(number, meaning) end,
})
env.M = M

return M
