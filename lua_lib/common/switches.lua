-- What the machine switches besides its spindle, whatever the dialect. A switch happens at rest.

local word = use("core/words", "word")
local path = use "core/path"

word("M10", function() path.event("abrasive_on") end)
word("M11", function() path.event("abrasive_off") end)
