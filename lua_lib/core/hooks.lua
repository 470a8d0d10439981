-- What happens by the way: hooks of words (core/words.lua) and of events, each under a name. Of several at one place the order
-- is that of this list, wherever they are said.

local ORDER = {
  "compensation", "rotation", "modal codes", "modal state", "named parameters", "numbered parameters", "motions",
  "process", "times",
}

local rank = {}
for place, name in ipairs(ORDER) do rank[name] = place end

local hooks = {}

function hooks.new(name, call, kind)
  if rank[name] == nil then error(("lua_lib/core/hooks.lua has no hook '%s' in its order"):format(name), 0) end
  return { rank = rank[name], call = call, kind = kind }
end

-- Puts a hook into a list by its rank; of one name the earlier one is first.
function hooks.insert(list, hook)
  local place = #list + 1
  while place > 1 and list[place - 1].rank > hook.rank do place = place - 1 end
  table.insert(list, place, hook)
end

-- Events, each with its listeners:
--   "begin"      all files are loaded
--   "shape"      plain motions go by Lua from here on, or no longer (core/shape.lua)
--   "frame"      another work coordinate system is in force (9/Series)
--   "transform"  the matrix of the program is another one (9/Series)
--   "call"       a subprogram begins: frame, arguments or nil (core/calls.lua)
--   "return"     it ends: frame
local listeners = { begin = {}, shape = {}, frame = {}, transform = {}, call = {}, ["return"] = {} }

function hooks.on(event, name, f) hooks.insert(listeners[event], hooks.new(name, f)) end

-- Those of an event, in their order; of one that happens so often that it is told by hand.
function hooks.listeners(event) return listeners[event] end

function hooks.tell(event, ...)
  local list = listeners[event]
  for i = 1, #list do list[i].call(...) end
end

return hooks
