-- What the machine switches: the jet, the abrasive, the spindle. A switch happens at rest.

local function switch(kind)
  return function() path.event(kind) end
end

-- Where the machine file does not say what switches the process ([process]), this is a waterjet.
local function jet(on)
  if core.process == nil then return function() core.set_process(on, false) end end
end

local jet_on, jet_off = jet(true), jet(false)

word("M8", function()
  local changed = not state.flood
  state.flood = true
  if jet_on then path.act(jet_on) end
  path.event("jet_on", nil, nil, changed)
end)

word("M9", function()
  local changed = state.flood or state.mist or false
  state.flood, state.mist = false, false
  if jet_off then path.act(jet_off) end
  path.event("jet_off", nil, nil, changed)
end)

word("M10", switch("abrasive_on"))
word("M11", switch("abrasive_off"))

word("M3", function() turn_spindle("cw") end)
word("M4", function() turn_spindle("ccw") end)
word("M5", function() turn_spindle(nil) end)
