-- Modes of Klipper, its offsets and speed factor, and the commands at which it waits.

local dialect = use "core/dialect"
local alarm = use("core/basics", "alarm")
local word = use("core/words", "word")
local moves, path, state = dialect.use "moves", use "core/path", dialect.use "state"

local LETTERS = { "x", "y", "z", "e" }
local STALL_S = 0.1   -- before and after a command that switches the motors off

word("G90", function() state.incremental = false end)
word("G91", function() state.incremental = true end)
word("M82", function() state.incremental_e = false end)
word("M83", function() state.incremental_e = true end)
word("G21", function() end)
word("G20", function() alarm("mode", "G20: Klipper does not support inches") end)

word("G4", function(words)
  local ms = words and words.p or 0
  if ms < 0 then alarm("word-value", "G4 P%.10g: a dwell must be 0 ms or more", ms) end
  path.dwell(ms / 1000)
end)

for _, name in ipairs { "M18", "M84" } do
  word(name, function()
    path.dwell(STALL_S)
    path.dwell(STALL_S)
    state.motors_off = true
  end)
end

word("M400", function() path.wait() end)

-- Sets the position to these values; without words to 0 for all.
word("G92", function(words)
  local all = words == nil or next(words) == nil
  for _, letter in ipairs(LETTERS) do
    local value = all and 0 or words[letter]
    if value then
      state.base[letter] = state.position(letter) - value * (letter == "e" and state.e_factor or 1)
    end
  end
end)

local function percent(words, name)
  local value = words and words.s or 100
  if value <= 0 then alarm("word-value", "%s S%.10g: a factor must be greater than 0", name, value) end
  return value / 100
end

word("M220", function(words) state.speed_factor = percent(words, "M220") end)

-- E continues from the value that it shows.
word("M221", function(words)
  local position, factor = state.position "e", percent(words, "M221")
  state.base.e = position - (position - state.origin "e") / state.e_factor * factor
  state.e_factor = factor
end)

local SAVED_FIELDS = { "incremental", "incremental_e", "feed", "speed_factor", "e_factor" }

local function save(name)
  local kept = { base = {}, offset = {}, position = {} }
  for _, field in ipairs(SAVED_FIELDS) do kept[field] = state[field] end
  for _, letter in ipairs(LETTERS) do
    kept.base[letter], kept.offset[letter] = state.base[letter], state.offset[letter]
    kept.position[letter] = state.position(letter)
  end
  state.saved[name] = kept
end

-- Shifts E's zero point by the distance moved since the save.
local function restore(name)
  local kept = state.saved[name]
  if kept == nil then alarm("mode", "RESTORE_GCODE_STATE: unknown state '%s'", name) end
  for _, field in ipairs(SAVED_FIELDS) do state[field] = kept[field] end
  state.base, state.offset = {}, {}
  for _, letter in ipairs(LETTERS) do
    state.base[letter], state.offset[letter] = kept.base[letter], kept.offset[letter]
  end
  state.base.e = state.origin "e" + state.position "e" - kept.position.e
  return kept
end

-- Moves at `mm_s`, or else at the active speed, which does not change.
local function move_to(target, mm_s)
  local feed = state.feed
  if mm_s then state.feed = mm_s * 60 / state.speed_factor end
  moves.to(target)
  state.feed = feed
end

word("SET_GCODE_OFFSET", function(words)
  local target = {}
  words = words or {}
  for _, letter in ipairs(LETTERS) do
    local before = state.offset[letter] or 0
    local adjust = words[letter .. "_adjust"]
    local offset = words[letter] or adjust and before + adjust
    if offset then
      state.offset[letter] = offset
      state.base[letter] = state.origin(letter) + offset - before
      target[letter] = state.position(letter) + offset - before
    end
  end
  if (words.move or 0) ~= 0 then move_to(target, words.move_speed) end
end)

local function state_name(words) return words and words.name or "default" end

word("SAVE_GCODE_STATE", function(words) save(state_name(words)) end)

word("RESTORE_GCODE_STATE", function(words)
  local kept = restore(state_name(words))
  if words == nil or (words.move or 0) == 0 then return end
  move_to({ x = kept.position.x, y = kept.position.y, z = kept.position.z }, words.move_speed)
end)

return { save = save, restore = restore }
