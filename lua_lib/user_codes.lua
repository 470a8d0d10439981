-- User M codes: a script, or the machine data, defines `M[101] = function(words) ... end`; a program calls it by its
-- number.

local LAST = 999

local defined = {}
local ids = {}   -- word id by number: a code that is defined anew keeps its id
local watchers = {}

local function nothing() end

local function undefined(number)
  return function()
    alarm("code-unknown",
      "M%s means nothing on this machine; define it before the program runs: M[%s] = function(words) ... end",
      tostring(number), tostring(number))
  end
end

local function check(number, meaning)
  local whole = math.tointeger(number)
  if whole == nil or whole < 0 or whole > LAST then
    alarm("script", "M[%s]: the number of an M code is a whole number from 0 to %d", tostring(number), LAST)
  end
  if rawget(env, "M" .. whole) ~= nil then
    alarm("script", "M[%d]: M%d is a code of the control itself", whole, whole)
  end
  if meaning ~= nil and type(meaning) ~= "function" then
    alarm("script", "M[%d] takes a function: M[%d] = function(words) ... end", whole, whole)
  end
  return whole
end

local function make_word(whole, meaning)
  ids[whole] = ids[whole] or word_id()
  defined[whole] = core.word(ids[whole], function(words)
    check_table(words, ("M[%d]"):format(whole))
    if watchers[whole] then return watchers[whole](words or {}, meaning) end
    return meaning(words or {})
  end)
end

local function define(number, meaning)
  local whole = check(number, meaning)
  if meaning == nil and watchers[whole] == nil then
    defined[whole] = nil
  else
    make_word(whole, meaning or nothing)
  end
end

-- watch(words, meaning) is called in place of the code's meaning, which does nothing until someone defines it. A later
-- watch has an earlier one for the meaning.
function watch_user_code(number, watch)
  local inner = watchers[number]
  watchers[number] = inner == nil and watch or function(words, meaning)
    return watch(words, function(own_words) return inner(own_words, meaning) end)
  end
  make_word(number, nothing)
end

env.M = setmetatable({}, {
  __index = function(_, number) return defined[number] or undefined(number) end,
  __newindex = function(_, number, meaning) define(number, meaning) end,
})
