-- Feed, feed modes, spindle speed, dwell.

word("F", function(value)
  if given(value, "F") then core.set_feed(value) end
end)

local function feed_mode(mode)
  return function()
    state.feed_mode = mode
    core.set_feed_mode(mode)
  end
end
word("G93", feed_mode("inverse"))
word("G94", feed_mode("minute"))
word("G95", feed_mode("revolution"))

word("S", function(value)
  if not given(value, "S") then return end
  if value < 0 then alarm("S is a speed from 0 on, not %.10g", value) end
  state.spindle_rpm = value
  core.set_spindle(value)
end)

word("G4", function(words)
  if type(words) ~= "table" then alarm("G4 takes one of P, X and U, its seconds") end
  local seconds = words.p or words.x or words.u
  if given(seconds, "G4") then path.dwell(seconds) end
end)
