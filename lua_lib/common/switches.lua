-- Switches of the machine in addition to its spindle, for all dialects. A switch happens at standstill.

local word = use("core/words", "word")
local path = use "core/path"

word("M10", function() path.event("abrasive_on") end)
word("M11", function() path.event("abrasive_off") end)
