-- RS274/NGC: M70 to M73 save and restore the modal state.

local dialect = use "core/dialect"
local alarm, copied = use("core/basics", "alarm", "copied")
local hooks, state, switches, systems, words =
  use "core/hooks", use "core/state", dialect.use "overrides", dialect.use "frames", use "core/words"

local word = words.word

-- The active code by modal group of the dialect's table, with the defaults at the start of a run.
local active = {
  units = core.unit_mm() == 1 and "G21" or "G20", plane = "G17", ["distance mode"] = "G90", ["arc centre mode"] = "G91_1",
  ["feed mode"] = "G94", ["cutter compensation"] = "G40", ["tool length"] = "G49", ["return level of cycles"] = "G99",
  ["spindle speed mode"] = "G97", ["path mode"] = "G64",
}
local words_by_group = {}   -- by group, the words with which its code was called

local saved_modes          -- of the subroutine

local function note(name, group)
  words.after(name, "modal state", function(_, given) active[group], words_by_group[group] = name, given end)
end

for name, group in unordered(core.codes.group) do
  if active[group] then note(name, group) end
end

local function keep(automatic)
  saved_modes = {
    automatic = automatic,
    active = copied(active), words_by_group = copied(words_by_group), overrides = switches.keep(), system = systems.active_system,
    feed = state.feed, speed = state.spindle_word, spindle = state.spindle,
    mist = state.mist, flood = state.flood,
  }
end

-- Calls the saved code of the group again if another one is active now.
local function restore_group(saved, group)
  local name = saved.active[group]
  if active[group] ~= name then env[name](saved.words_by_group[group]) end
end

local function restore_coolant(saved)
  if saved.mist == state.mist and saved.flood == state.flood then return end
  env.M9()
  if saved.mist then env.M7() end
  if saved.flood then env.M8() end
end

-- LinuxCNC restores F and S by writing them out if their numbers have changed: F to a tenth and S as an
-- integer. It ignores units, and writes them before the codes that drop F.
local function written_values(saved)
  return {
    F = state.feed ~= saved.feed and tonumber(("%.1f"):format(saved.feed)) or nil,
    S = state.spindle_word ~= saved.speed and tonumber(("%.0f"):format(saved.speed)) or nil,
  }
end

local function restore_spindle(saved)
  if state.spindle == saved.spindle then return end
  if saved.spindle == "cw" then env.M3() elseif saved.spindle == "ccw" then env.M4() else env.M5() end
end

-- Restores the tool length as the length of the loaded tool, as in LinuxCNC.
local function restore_length(saved)
  if saved.active["tool length"] == active["tool length"] then return end
  local name = saved.active["tool length"]
  if name == "G49" or name == "G43_4" then env[name]() else env.G43() end
end

local groups = {
  "units", "plane", "cutter compensation", "distance mode", "arc centre mode", "return level of cycles", "path mode",
  "spindle speed mode", "feed mode",
}

-- Adds a group that M70 saves; `code` is active in it when a run begins.
local function save_group(group, code)
  active[group] = code
  groups[#groups + 1] = group
  for name, of in unordered(core.codes.group) do
    if of == group then note(name, group) end
  end
end

local function restore(saved)
  local written = written_values(saved)
  for _, group in ipairs(groups) do restore_group(saved, group) end
  if saved.system ~= systems.active_system then env[systems.words[saved.system]]() end
  restore_length(saved)
  for name, value in pairs(written) do env[name](value) end
  restore_spindle(saved)
  restore_coolant(saved)
  switches.restore(saved.overrides)
end

word("M70", function() keep(false) end)
word("M71", function() saved_modes = nil end)
word("M73", function() keep(true) end)
word("M72", function()
  if saved_modes == nil then
    alarm("mode", "M72 restores what M70 or M73 has saved in the same subroutine, but nothing is saved")
  end
  restore(saved_modes)
end)

-- The state returns automatically at the end of a subroutine that M73 has marked.
hooks.on("call", "modal state", function(frame)
  frame.saved, saved_modes = saved_modes, nil
end)
hooks.on("return", "modal state", function(frame)
  if saved_modes and saved_modes.automatic then restore(saved_modes) end
  saved_modes = frame.saved
end)

return { active = active, save_group = save_group }
