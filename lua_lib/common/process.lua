-- Words that switch the machine's process: those that [process] of the machine file names, whatever their
-- meaning in the dialect. core.process is nil without such a table, else { kind = "jet", on = {...}, off =
-- {...} } with entries { code = "M62", text = "M62 P0", words = { p = 0 } }.

local path, words = use "core/path", use "core/words"

local process = {}

local by_code = {}   -- code -> entries

local function add_entries(list, on)
  for _, entry in ipairs(list) do
    entry.on = on
    by_code[entry.code] = by_code[entry.code] or {}
    table.insert(by_code[entry.code], entry)
  end
end

-- Returns the effect of a word on the process: an entry with `on`, or nil.
function process.entry(code, given)
  for _, entry in ipairs(by_code[code] or {}) do
    local fits = true
    for letter, value in pairs(entry.words) do
      fits = fits and type(given) == "table" and given[letter] == value
    end
    if fits then return entry end
  end
end

-- Outputs that switch with the next move.
local WITH_MOTION = { M62 = true, M63 = true, M67 = true }

local switching   -- the entry of the word that acts

local function event_kind(entry) return core.process.kind .. (entry.on and "_on" or "_off") end

-- Calls act(...) as a word that may switch the process.
function process.call_switch_word(code, given, act, ...)
  local entry = by_code[code] and process.entry(code, given)
  if entry == nil then return act(...) end
  path.act(function() core.set_process(entry.on, WITH_MOTION[code] or false) end)
  switching = entry
  local result = act(...)
  if switching == entry then   -- it sent no event
    switching = nil
    path.event(event_kind(entry), entry.text)
  end
  return result
end

if core.process == nil then return process end

add_entries(core.process.on, true)
add_entries(core.process.off, false)

-- Events for the function of a switching word; they are replaced by events for its function here.
local replaced_kinds = {}
for _, kind in ipairs { "jet_on", "jet_off", "abrasive_on", "abrasive_off", "coolant_2_on", "mist_on", "flood_on",
                        "coolant_off", "digital_output", "analog_output", "spindle_cw", "spindle_ccw", "spindle_off" } do
  replaced_kinds[kind] = true
end

path.set_event_filter(function(kind, detail)
  local entry = switching
  if entry == nil or not replaced_kinds[kind] then return kind, detail end
  switching = nil
  if core.process.kind == "spindle" or event_kind(entry) == kind then return kind, detail end
  return event_kind(entry), entry.text
end)

-- The spindle itself reports the switching of its words (common/spindle.lua).
local SPINDLE_CODES = { M3 = true, M4 = true, M5 = true }
for code in pairs(by_code) do
  if not SPINDLE_CODES[code] then
    words.around(code, "process", function(meaning, name, given, ...)
      return process.call_switch_word(name, given, meaning, given, ...)
    end)
  end
end

-- M19 stops the spindle.
if by_code.M5 then
  words.after("M19", "process", function() path.act(function() core.set_process(false, false) end) end)
end

return process
