-- Feed, spindle, tools, and modes that this version takes note of.

word("F", function(value)
  if given(value, "F") then core.set_feed(value) end
end)

word("G93", function() core.set_feed_mode("inverse") end)
word("G94", function() core.set_feed_mode("minute") end)
word("G95", function() core.set_feed_mode("revolution") end)
word("G97", function() end)  -- spindle speed in rev/min, the only mode so far

word("S", function(value)
  if not given(value, "S") then return end
  if value < 0 then alarm("S is a speed from 0 on, not %.10g", value) end
  core.set_spindle(value)
end)

word("T", function(value)
  if given(value, "T") then core.event("tool_select", ("T%.10g"):format(value)) end
end)
word("M6", function() core.event("tool_change") end)

-- Numbers of offsets: in force only with compensation (G41, G42, G43), which is not there yet.
word("D", function(value) given(value, "D") end)
word("H", function(value) given(value, "H") end)

-- Switching off what cannot be on changes nothing.
for _, name in ipairs { "G40", "G49", "G80", "G67", "G69", "G14", "G14_1", "G23", "G98", "G99" } do
  word(name, function() end)
end

-- Each move comes to rest at its end, which is what G09 and G61 ask for.
word("G9", function() end)
word("G61", function() end)
word("G64", function()
  core.warn("G64 (cutting mode): this version brings every move to rest; a control that does not is faster")
end)

word("G4", function(words)
  if type(words) ~= "table" then alarm("G4 takes one of P, X and U, its seconds") end
  local seconds = words.p or words.x or words.u
  if given(seconds, "G4") then core.dwell(seconds) end
end)
