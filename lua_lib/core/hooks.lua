-- Hooks of words (core/words.lua) and of events, each with a name. If several have the same position, their
-- order is that of this list, in any order of definition.

local ORDER = {
  "compensation", "rotation", "modal codes", "modal state", "named parameters", "numbered parameters", "motions",
  "process", "times",
}

local rank = {}
for place, name in ipairs(ORDER) do rank[name] = place end

local hooks = {}

function hooks.new(name, call, kind)
  if rank[name] == nil then error(("hook '%s' is not in the order of lua_lib/core/hooks.lua"):format(name), 0) end
  return { rank = rank[name], call = call, kind = kind }
end

-- Inserts a hook into a list by its rank; if names are equal the earlier one is first.
function hooks.insert(list, hook)
  local place = #list + 1
  while place > 1 and list[place - 1].rank > hook.rank do place = place - 1 end
  table.insert(list, place, hook)
end

-- Events, each with its listeners:
--   "begin"      all files are loaded
--   "shape"      plain motions run in Lua from here on, or no longer (core/motion_modifiers.lua)
--   "frame"      another work coordinate system is active (9/Series)
--   "transform"  the matrix of the program has changed (9/Series)
--   "call"       a subprogram begins: frame, arguments or nil (core/calls.lua)
--   "return"     it ends: frame
local listeners = { begin = {}, shape = {}, frame = {}, transform = {}, call = {}, ["return"] = {} }

function hooks.on(event, name, f) hooks.insert(listeners[event], hooks.new(name, f)) end

-- Returns the listeners of an event, in their order; for an event so frequent that its source calls them
-- itself.
function hooks.listeners(event) return listeners[event] end

function hooks.tell(event, ...)
  local list = listeners[event]
  for i = 1, #list do list[i].call(...) end
end

return hooks
