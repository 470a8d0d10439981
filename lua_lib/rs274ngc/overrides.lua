-- RS274/NGC: the operator's overrides and hold (M48 to M53), and the stop for a pallet change (M60). They are
-- events, and parameters show which of them are enabled. As in LinuxCNC, the feed switch also applies to
-- rapid moves, and a move keeps the settings that were active when it was programmed. Adaptive feed and feed
-- hold have no input here.

local dialect = use "core/dialect"
local copied = use("core/basics", "copied")
local word = use("core/words", "word")
local ngc_modes, overrides, path = dialect.use "modes", use "common/overrides", use "core/path"

local switches = {}

local enabled = { feed = true, speed = true, adaptive = false, hold = true }

function switches.is_enabled(name) return enabled[name] end

local function set(names, on)
  for _, name in ipairs(names) do
    local changed = enabled[name] ~= on
    enabled[name] = on
    path.event("override", ("%s %s"):format(name, on and "enabled" or "disabled"), nil, changed)
  end
  overrides.lock("M48 to M51", { feed = not enabled.feed, rapid = not enabled.feed, spindle = not enabled.speed })
end

for name, on in pairs { M48 = true, M49 = false } do
  word(name, function()
    set({ "feed", "speed" }, on)
  end)
end

-- P0 switches it off, another P or none switches it on.
for name, what in pairs { M50 = "feed", M51 = "speed", M52 = "adaptive", M53 = "hold" } do
  word(name, function(words)
    ngc_modes.check_spindle(words, name, true)
    set({ what }, words == nil or words.p ~= 0)
  end)
end

word("M60", function()
  path.event("stop", "change of pallets")
end)

-- For M70 to M73: `keep` returns the state, `restore` sets it again.
function switches.keep() return copied(enabled) end

function switches.restore(kept)
  for _, name in ipairs { "feed", "speed", "adaptive", "hold" } do
    if enabled[name] ~= kept[name] then set({ name }, kept[name]) end
  end
end

return switches
