-- Rapid and linear moves and the modal motion.

local alarm, check_table = use("core/basics", "alarm", "check_table")
local hooks, path, polar, word_keys, words = use "core/hooks", use "core/path", use "common/polar", use "core/word_keys", use "core/words"

local motion = {}

-- By the id of each motion: its name, and the function `move` while it is modal. The core stores which one is
-- modal.
local names, moves = {}, {}
core.set_modal_tables(env, names, moves)
motion.names = names

-- Adds a motion of that name; the result is for core.make_modal().
function motion.new(name, move)
  local id = words.id()
  names[id], moves[id] = name, move
  return id
end

-- Returns a motion that becomes modal, and its id: `move` is then the same without the change of mode.
local function modal_motion(name, meaning)
  local id = motion.new(name, core.word(words.id(), meaning))
  local word = core.word(id, function(values)
    core.make_modal(id)
    meaning(values)
  end)
  return word, id
end

-- Defines the word of a motion that is modal.
function motion.modal_word(name, meaning)
  env[name] = modal_motion(name, word_keys(name, words.with_compensation_check(name, meaning)))
end

-- Plain motions are C++ as long as no filter or macro changes them (core/motion_modifiers.lua): by name the word and its
-- id.
local plain, shaped = {}, {}
local active_motions = plain

-- Defines the word of such a motion. word_in_core(id) and move_in_core(id) make it and its `move` in C++;
-- `meaning` is the same in Lua, for use if a filter or macro is between the word and the machine.
function motion.plain_word(name, word_in_core, move_in_core, meaning)
  local id = motion.new(name, move_in_core(words.id()))
  plain[name], shaped[name] = { word = word_in_core(id), id = id }, {}
  shaped[name].word, shaped[name].id = modal_motion(name, meaning)
  env[name] = plain[name].word
end

-- Returns the motion of an id; for a plain one the variant that is in use now.
function motion.active_variant(id)
  local name = names[id]
  local is_plain = plain[name] and (id == plain[name].id or id == shaped[name].id)
  return is_plain and active_motions[name].id or id
end

-- A word that a script has redefined since stays as it is.
local function activate_motions(motions)
  for name, own in unordered(motions) do
    if env[name] == active_motions[name].word then env[name] = own.word end
  end
  active_motions = motions
  local modal = motion.active_variant(core.motion_id())
  if modal ~= core.motion_id() then core.make_modal(modal) end
end

-- Words may have temporary replacements, in layers: the last layer is nearest to the program.
local LAYERS = { "modal macro", "line angle" }
local replacements, replaced = {}, {}   -- meanings by name: of each layer, and those they replace

local function restore_words()
  for name, meaning in unordered(replaced) do env[name] = meaning end
  replaced = {}
end

local function apply_replacements()
  for _, layer in ipairs(LAYERS) do
    for name, meaning in unordered(replacements[layer] or {}) do
      replaced[name] = replaced[name] or env[name]
      env[name] = meaning
    end
  end
end

-- Replaces these words by `meanings` by name; nil: ends the layer.
function motion.replace_words(layer, meanings)
  if replacements[layer] == meanings then return end
  restore_words()
  replacements[layer] = meanings
  apply_replacements()
end

-- Plain words change below their replacements.
hooks.on("shape", "motions", function(is_shaped)
  restore_words()
  activate_motions(is_shaped and shaped or plain)
  apply_replacements()
end)

local function line(name, rapid)
  local function line_in_lua(values)
    check_table(values, name)
    if values == nil then return end
    local target, named = core.target(polar.resolve(values))
    if not named then return end
    if rapid then path.rapid(target) else path.line(target) end
  end
  motion.plain_word(name, function(id) return core.line_word(rapid, id) end,
    function(id) return core.modal_line_word(rapid, id) end, line_in_lua)
end
line("G0", true)
line("G1", false)

-- No motion is modal, so axis words need one.
local none = motion.new("G80", core.word(words.id(), function()
  alarm("mode", "axis words need a motion code; G80 has ended the active one")
end))
function motion.end_motion() core.make_modal(none) end

local initial_motion = use("core/dialect", "initial_motion")
core.make_modal(initial_motion == "none" and none or plain[initial_motion].id)

return motion
