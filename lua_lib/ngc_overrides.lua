-- RS274/NGC: the operator's overrides and hold (M48 to M53), and the stop for a change of pallets (M60). Nobody
-- turns them in a simulation: they are events, and parameters tell which of them may be used.

local enabled = { feed = true, speed = true, adaptive = false, hold = true }

function ngc.override(name) return enabled[name] end

local function set(names, on)
  for _, name in ipairs(names) do
    enabled[name] = on
    path.event("override", ("%s %s"):format(name, on and "enabled" or "disabled"))
  end
end

for name, on in pairs { M48 = true, M49 = false } do
  word(name, function()
    ngc.not_in_compensation(name)
    set({ "feed", "speed" }, on)
  end)
end

-- With P0 it is off, with another P or none it is on.
for name, what in pairs { M50 = "feed", M51 = "speed", M52 = "adaptive", M53 = "hold" } do
  word(name, function(words)
    check_table(words, name)
    ngc.check_spindle(words or {}, name)
    ngc.not_in_compensation(name)
    set({ what }, words == nil or words.p ~= 0)
  end)
end

word("M60", function()
  stop_in_compensation()
  path.event("stop", "change of pallets")
end)

-- For M70 to M73: the state, and its return.
function ngc.keep_overrides()
  local kept = {}
  for name, on in pairs(enabled) do kept[name] = on end
  return kept
end

function ngc.restore_overrides(kept)
  for name, on in pairs(kept) do
    if enabled[name] ~= on then set({ name }, on) end
  end
end
