-- The control in Lua: what each word of a part program means. This folder can be copied, changed and given to
-- gsim-run with --lua-lib. `core` is the C++ side (see README.md beside this file), `env` is what scripts see.

include "word_keys"
include "state"
include "modules"
include "processes"
include "variables"
include "programs"
include "frames"
include "feed"
include "motion"
include "path"
include "overrides"
include "arcs"
include "polar"
include "tools"
include "cycles"
include "threads"
include "compensation"
include "switches"
include "user_codes"
include "probe"
include "neutral"
include "zones"

-- What belongs to one dialect.
if core.dialect == "rs274ngc" then
  include "ngc_variables"
  include "ngc_named"
  include "ngc_subs"
  include "ngc_messages"
  include "ngc_frames"
  include "ngc_modes"
  include "ngc_polar"
  include "ngc_g10"
  include "ngc_home"
  include "ngc_io"
  include "ngc_overrides"
  include "ngc_probe"
  include "splines"
  include "ngc_splines"
  include "ngc_computed"
  include "ngc_shared"
  include "ngc_context"   -- the last one: it watches the words that the others define
else
  include "ab9_transform"
  include "ab9_data"
  include "ab9_zones"
  include "ab9_home"
  include "ab9_macros"
  include "ab9_geometry"
  include "ab9_corners"
  include "ab9_angles"
  include "ab9_print"
  include "ab9_modes"
  include "ab9_ramps"
  include "ab9_variables"
  include "ab9_modal"     -- the last one: it remembers the words that the others define
end

include "process"       -- watches the words that the others define
include "times"         -- watches them, too
include "stored_data"   -- knows what the run begins with

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
