-- What the machine switches: the jet, the abrasive, the spindle. A switch happens at rest.

local function switch(kind, act)
  return function()
    if act then act() end
    core.event(kind)
  end
end

word("M8", switch("jet_on", function() core.jet(true) end))
word("M9", switch("jet_off", function() core.jet(false) end))
word("M10", switch("abrasive_on"))
word("M11", switch("abrasive_off"))
word("M3", switch("spindle_cw"))
word("M4", switch("spindle_ccw"))
word("M5", switch("spindle_off"))
