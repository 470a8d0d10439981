-- The control in Lua: what each word of a part program means. This folder can be copied, changed and given to
-- gsim-run with --lua-lib. `core` is the C++ side (see README.md beside this file), `env` is what scripts see.

include "state"
include "variables"
include "programs"
include "frames"
include "feed"
include "motion"
include "arcs"
include "polar"
include "switches"
include "neutral"

-- A name that nothing defines is a mistake, not a vacant value.
local known = {}
for name in pairs(env) do known[#known + 1] = name end
table.sort(known)

local function same_but_case(name)
  for _, candidate in ipairs(known) do
    if candidate:lower() == name:lower() then return candidate end
  end
end

setmetatable(env, {
  __index = function(_, name)
    local near = type(name) == "string" and same_but_case(name)
    error(("there is no '%s' here%s"):format(tostring(name), near and ("; did you mean " .. near .. "?") or ""), 2)
  end,
})
