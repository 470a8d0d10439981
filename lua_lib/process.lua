-- What switches the machine's process: the words that [process] of the machine file names, whatever the dialect has
-- them for. core.process is nil where there is no such table, else { kind = "jet", on = {...}, off = {...} } with
-- entries { code = "M62", text = "M62 P0", words = { p = 0 } }. Loaded behind all files that define words.

local process = core.process

-- What a word does to the process: an entry with `on`, or nil.
function process_entry() end

if process == nil then return end

local is_spindle = process.kind == "spindle"
local by_code = {}   -- code -> entries

local function add_entries(list, on)
  for _, entry in ipairs(list) do
    entry.on = on
    by_code[entry.code] = by_code[entry.code] or {}
    table.insert(by_code[entry.code], entry)
  end
end
add_entries(process.on, true)
add_entries(process.off, false)

-- Events that say what a switching word does; in its place they say what it does here.
local says_what = {}
for _, kind in ipairs { "jet_on", "jet_off", "abrasive_on", "abrasive_off", "coolant_2_on", "mist_on", "flood_on",
                        "coolant_off", "digital_output", "analog_output", "spindle_cw", "spindle_ccw", "spindle_off" } do
  says_what[kind] = true
end

local switching   -- the entry of the word that acts
local event = path.event

local function own_kind(entry) return process.kind .. (entry.on and "_on" or "_off") end

function path.event(kind, detail, when, changed)
  local entry = switching
  if entry == nil or not says_what[kind] then return event(kind, detail, when, changed) end
  switching = nil
  if is_spindle or own_kind(entry) == kind then return event(kind, detail, when, changed) end
  return event(own_kind(entry), entry.text, when, changed)
end

function process_entry(code, words)
  for _, entry in ipairs(by_code[code] or {}) do
    local fits = true
    for letter, value in pairs(entry.words) do
      fits = fits and type(words) == "table" and words[letter] == value
    end
    if fits then return entry end
  end
end

-- Outputs that come with the next move.
local WITH_MOTION = { M62 = true, M63 = true, M67 = true }

-- act(...), as a word that may switch the process.
local function switched_by(code, words, act, ...)
  local entry = process_entry(code, words)
  if entry == nil then return act(...) end
  path.act(function() core.set_process(entry.on, WITH_MOTION[code] or false) end)
  switching = entry
  local result = act(...)
  if switching == entry then   -- it said nothing
    switching = nil
    event(own_kind(entry), entry.text)
  end
  return result
end

-- The spindle turns and stops by words, by cycles and with a change of the tool.
local SPINDLE = { cw = "M3", ccw = "M4" }
local STOP = "M5"
local turn, orient = turn_spindle, orient_spindle

function turn_spindle(direction)
  switched_by(SPINDLE[direction] or STOP, nil, turn, direction)
end

function orient_spindle()
  switched_by(STOP, nil, orient)
end

local function watch(code)
  local meaning = rawget(env, code)
  if meaning ~= nil then
    env[code] = function(words) return switched_by(code, words, meaning, words) end
  else
    watch_user_code(tonumber(code:sub(2)), function(words, act) return switched_by(code, words, act, words) end)
  end
end

for code in pairs(by_code) do
  if code ~= SPINDLE.cw and code ~= SPINDLE.ccw and code ~= STOP then watch(code) end
end

-- M19 stops the spindle.
local orientation = rawget(env, "M19")
if orientation and by_code[STOP] then
  env.M19 = function(words)
    orientation(words)
    path.act(function() core.set_process(false, false) end)
  end
end
