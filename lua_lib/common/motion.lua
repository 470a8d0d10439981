-- Rapid and linear moves and the modal motion.

local alarm, check_table = use("core/basics", "alarm", "check_table")
local hooks, path, polar, word_keys, words = use "core/hooks", use "core/path", use "common/polar", use "core/word_keys", use "core/words"

local motion = {}

-- Of each motion by its id: its name, and what `move` is where it is modal. Which one is modal, the core knows.
local names, moves = {}, {}
core.set_modal_tables(env, names, moves)
motion.names = names

-- A motion of that name; the result is for core.make_modal().
function motion.new(name, move)
  local id = words.id()
  names[id], moves[id] = name, move
  return id
end

-- A motion that becomes modal, and its id: `move` is then the same without the change of mode.
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
  env[name] = modal_motion(name, word_keys(name, words.if_allowed(name, meaning)))
end

-- Plain motions are C++ as long as nothing shapes them (core/shape.lua): by name the word and its id.
local plain, shaped = {}, {}
local in_use = plain

-- Defines the word of such a motion. word_in_core(id) and move_in_core(id) make it and its `move` in C++; `meaning` is
-- the same in Lua, for when something stands between the word and the machine.
function motion.plain_word(name, word_in_core, move_in_core, meaning)
  local id = motion.new(name, move_in_core(words.id()))
  plain[name], shaped[name] = { word = word_in_core(id), id = id }, {}
  shaped[name].word, shaped[name].id = modal_motion(name, meaning)
  env[name] = plain[name].word
end

-- The motion of an id; of a plain one as it is in use now.
function motion.as_in_use(id)
  local name = names[id]
  local is_plain = plain[name] and (id == plain[name].id or id == shaped[name].id)
  return is_plain and in_use[name].id or id
end

-- What has been defined anew since stays as it is.
local function put_in_use(motions)
  for name, own in unordered(motions) do
    if env[name] == in_use[name].word then env[name] = own.word end
  end
  in_use = motions
  local modal = motion.as_in_use(core.motion_id())
  if modal ~= core.motion_id() then core.make_modal(modal) end
end

-- For a while other meanings may stand in for words, in layers: the last one is nearest to the program.
local LAYERS = { "modal macro", "line angle" }
local covers, covered = {}, {}   -- meanings by name: of each layer, and what they stand for

local function uncover()
  for name, meaning in unordered(covered) do env[name] = meaning end
  covered = {}
end

local function put_covers()
  for _, layer in ipairs(LAYERS) do
    for name, meaning in unordered(covers[layer] or {}) do
      covered[name] = covered[name] or env[name]
      env[name] = meaning
    end
  end
end

-- `meanings` by name stand in for these words; nil: the layer's no longer.
function motion.cover(layer, meanings)
  if covers[layer] == meanings then return end
  uncover()
  covers[layer] = meanings
  put_covers()
end

-- Plain words change behind what stands in for them.
hooks.on("shape", "motions", function(is_shaped)
  uncover()
  put_in_use(is_shaped and shaped or plain)
  put_covers()
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

-- No motion is modal: axis words need one.
local none = motion.new("G80", core.word(words.id(), function()
  alarm("mode", "axis words need a motion, and G80 has ended the one that was in force")
end))
function motion.end_motion() core.make_modal(none) end

-- In RS274/NGC axis words need a motion of the program's own.
core.make_modal(core.dialect == "rs274ngc" and none or plain.G0.id)

return motion
