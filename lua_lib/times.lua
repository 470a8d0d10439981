-- How long words take: [times] of the machine file, in s. core.times is nil where there is no such table, else
-- { tool_change = 8.0, ..., codes = { M100 = 0.5 } }.

local path, process, words = use "path", use "process", use "words"

local times = core.times
if times == nil then return end

local named = {
  M3 = times.spindle_start, M4 = times.spindle_start, M5 = times.spindle_stop,
  M6 = times.tool_change, M7 = times.coolant_on, G10 = times.tool_table,
}
local tool_tables = { [10] = true, [11] = true }  -- L of G10
if core.dialect == "rs274ngc" then
  named.M8, named.M9 = times.coolant_on, times.coolant_off
  tool_tables[1] = true
else
  if core.process == nil then named.M8, named.M9 = times.process_on, times.process_off end
  tool_tables[12], tool_tables[13] = true, true
end

local function time_of(code, given)
  if times.codes[code] then return times.codes[code] end
  if code == "G10" and not tool_tables[given.l] then return 0 end
  local entry = process.entry(code, given)
  local of_process = entry and (entry.on and times.process_on or times.process_off) or 0
  return of_process > 0 and of_process or named[code] or 0
end

local function take_time(code, given)
  local seconds, place = time_of(code, given), core.place()
  if seconds > 0 then path.act(function() core.take_time(seconds, place) end) end
end

local timed = {}
for _, codes in ipairs { named, times.codes } do
  for code in pairs(codes) do timed[code] = true end
end
for _, list in ipairs(core.process and { core.process.on, core.process.off } or {}) do
  for _, entry in ipairs(list) do timed[entry.code] = true end
end
for code in pairs(timed) do words.after(code, "times", take_time) end
