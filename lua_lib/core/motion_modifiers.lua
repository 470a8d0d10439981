-- Plain motions are C++ as long as no polar programming, filter of the path or modal macro call changes them.

local hooks = use "core/hooks"

local reasons = {}
local shaped = false

-- Sets or clears `reason` as something that modifies motion words before they reach the machine.
return function(reason, on)
  reasons[reason] = on or nil
  if (next(reasons) ~= nil) == shaped then return end
  shaped = not shaped
  hooks.tell("shape", shaped)
end
