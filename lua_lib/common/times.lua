-- Durations of words: [times] of the machine file, in s. core.times is nil without such a table, else {
-- tool_change = 8.0, ..., codes = { M100 = 0.5 } }.

local dialect, path, process, words = use "core/dialect", use "core/path", use "common/process", use "core/words"

local times = core.times
if times == nil then return end

-- Name of the time of each word.
local named = {
  M3 = "spindle_start", M4 = "spindle_start", M5 = "spindle_stop",
  M6 = "tool_change", M7 = "coolant_on", G10 = "tool_table",
}
for code, time in pairs(dialect.switch_times) do
  local is_of_process = time == "process_on" or time == "process_off"
  if core.process == nil or not is_of_process then named[code] = time end
end

-- Returns the duration, and the key of [times] that defines it.
local function time_for_code(code, given)
  if times.codes[code] then return times.codes[code], code end
  if code == "G10" and not dialect.tool_table_kinds[given.l] then return 0 end
  local entry = process.entry(code, given)
  local process_key = entry and (entry.on and "process_on" or "process_off")
  local name = process_key and times[process_key] > 0 and process_key or named[code]
  if not name then return 0 end
  return times[name], name .. "_s"
end

local function take_time(code, given)
  local seconds, key = time_for_code(code, given)
  local place = core.place()
  if seconds > 0 then path.act(function() core.take_time(seconds, key, place) end) end
end

local timed = {}
for _, codes in ipairs { named, times.codes } do
  for code in pairs(codes) do timed[code] = true end
end
for _, list in ipairs(core.process and { core.process.on, core.process.off } or {}) do
  for _, entry in ipairs(list) do timed[entry.code] = true end
end
for code in pairs(timed) do words.after(code, "times", take_time) end
