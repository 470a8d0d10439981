-- The registry of the names that scripts see. One file defines each word; other files hook calls before or
-- after it.
--   word(name, meaning)                   a word of the language
--   env.name = value                      while the library loads: any other name for scripts
--   words.before(names, hook, f)          f(name, ...) before the word, with its values
--   words.after(names, hook, f)           f(name, ...) after it
--   words.around(names, hook, f)          f(meaning, name, ...) instead of it, and can call meaning(...)
-- `names` is a name or a list of names; the names of hooks and their order are in core/hooks.lua. Names of
-- user M codes ("M101") and names that the dialect does not have can be hooked, too.

local alarm, copied, printed = use("core/basics", "alarm", "copied", "printed")
local compensation, hooks, path, word_keys = use "common/compensation", use "core/hooks", use "core/path", use "core/word_keys"

local words = {}

local seen = copied(env)     -- what scripts see, and
local owner = {}             -- which file has said it
local hooked = {}            -- hooks by the name of the word

local function register(_, name, value)
  if owner[name] then
    error(("'%s' is defined twice, in lua_lib/%s.lua and in lua_lib/%s.lua"):format(name, owner[name], core.loading()), 0)
  end
  seen[name], owner[name] = value, core.loading()
end

setmetatable(env, { __newindex = register })

local next_id = 0

function words.id()
  next_id = next_id + 1
  return next_id - 1
end

-- Returns the meaning of a word at which the controller waits by a special rule (core.stops, docs/stops.md).
local function with_stop_rule(name, meaning)
  local rule = core.stops[printed(name)]
  return rule and function(...) return path.call_with_stop_rule(rule, meaning, ...) end or meaning
end

local refusals = { refused = compensation.refuse, ["refused beside the path"] = compensation.reject_next_to_path }

-- Returns the meaning of a code, called after a check that cutter compensation allows it (column
-- `compensation`).
function words.with_compensation_check(name, meaning)
  local refuse, display_name = refusals[core.codes.compensation[name]], printed(name)
  if refuse == nil then return meaning end
  return function(...)
    refuse(display_name)
    return meaning(...)
  end
end

-- Defines a word of the language. A call belongs to the block at the line from which the script calls it.
function words.word(name, meaning)
  local looked_at = with_stop_rule(name, words.with_compensation_check(name, meaning))
  env[name] = core.word(words.id(), word_keys(name, looked_at))
end

-- Returns true if the controller itself has that name.
function words.is_known(name) return owner[name] ~= nil end

local kinds = {}

function kinds.before(name, meaning, f)
  return function(...)
    f(name, ...)
    return meaning(...)
  end
end

function kinds.after(name, meaning, f)
  return function(...)
    local result = meaning(...)
    f(name, ...)
    return result
  end
end

function kinds.around(name, meaning, f)
  return function(...) return f(meaning, name, ...) end
end

for kind in pairs(kinds) do
  words[kind] = function(names, hook, f)
    local new = hooks.new(hook, f, kind)
    for _, name in ipairs(type(names) == "table" and names or { names }) do
      if hooked[name] then hooks.insert(hooked[name], new) else hooked[name] = { new } end
    end
  end
end

function words.is_hooked(name) return hooked[name] ~= nil end

-- Returns the meaning of a word with all hooks before and after it.
function words.with_hooks(name, meaning)
  for _, hook in ipairs(hooked[name] or {}) do meaning = kinds[hook.kind](name, meaning, hook.call) end
  return meaning
end

local function find_ignoring_case(name)
  for candidate in pairs(seen) do
    if candidate:lower() == name:lower() then return candidate end
  end
end

-- An undefined name is an error, not an empty value.
local function unknown(_, name)
  local near = type(name) == "string" and find_ignoring_case(name)
  error(("'%s' is not defined here%s"):format(tostring(name), near and ("; did you mean " .. near .. "?") or ""), 2)
end

-- Rejects the codes that the dialect does not support in handwritten scripts, too.
local function define_unsupported()
  for name, meaning in unordered(core.codes.unsupported) do
    if not owner[name] then
      words.word(name, function() alarm("code-unsupported", "%s (%s) is not supported", printed(name), meaning) end)
    end
  end
end

-- Makes the words visible to scripts after all files have defined theirs.
function words.finish()
  define_unsupported()
  setmetatable(env, { __index = unknown })
  for name, value in unordered(seen) do env[name] = hooked[name] and words.with_hooks(name, value) or value end
end

return words
