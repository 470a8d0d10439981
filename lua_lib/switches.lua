-- What the machine switches: the jet, the abrasive, the spindle. A switch happens at rest.

local function switch(kind, act)
  return function()
    if act then path.act(act) end
    path.event(kind)
  end
end

word("M8", switch("jet_on", function() core.jet(true) end))
word("M9", switch("jet_off", function() core.jet(false) end))
word("M10", switch("abrasive_on"))
word("M11", switch("abrasive_off"))

word("M3", function() turn_spindle("cw") end)
word("M4", function() turn_spindle("ccw") end)
word("M5", function() turn_spindle(nil) end)
