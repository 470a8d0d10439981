-- What the machine switches: the jet, the abrasive, the spindle. A switch happens at rest.

local function switch(kind, act)
  return function()
    if act then path.act(act) end
    path.event(kind)
  end
end

-- Where the machine file does not say what switches the process ([process]), this is a waterjet.
local function jet(on)
  if core.process == nil then return function() core.set_process(on, false) end end
end

word("M8", switch("jet_on", jet(true)))
word("M9", switch("jet_off", jet(false)))
word("M10", switch("abrasive_on"))
word("M11", switch("abrasive_off"))

word("M3", function() turn_spindle("cw") end)
word("M4", function() turn_spindle("ccw") end)
word("M5", function() turn_spindle(nil) end)
