-- Plain motions are C++ as long as nothing shapes them: polar programming, a filter of the path, a modal macro call.

local hooks = use "core/hooks"

local reasons = {}
local shaped = false

-- Something stands between the words of motions and the machine for that reason, or does no longer.
return function(reason, on)
  reasons[reason] = on or nil
  if (next(reasons) ~= nil) == shaped then return end
  shaped = not shaped
  hooks.tell("shape", shaped)
end
