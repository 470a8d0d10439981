-- Rapid and linear moves and the modal motion.

local alarm, check_table = use("basics", "alarm", "check_table")
local hooks, path, polar, state, word_keys, words =
  use "hooks", use "path", use "polar", use "state", use "word_keys", use "words"

local motion = {}

-- Makes `name` the modal motion: `move` goes on with `meaning`.
local function make_modal(name, meaning)
  state.motion = name
  core.forget_modal_word()
  env.move = meaning
end
motion.make_modal = make_modal

-- A motion that becomes modal, and what `move` then is: the same without the change of mode.
local function modal_motion(name, meaning)
  local modal = core.word(words.id(), meaning)
  local word = core.word(words.id(), function(values)
    make_modal(name, modal)
    meaning(values)
  end)
  return word, modal
end

-- Defines the word of a motion that is modal.
function motion.modal_word(name, meaning)
  env[name] = modal_motion(name, word_keys(name, words.if_allowed(name, meaning)))
end

-- Plain motions are C++ as long as nothing shapes them (shape.lua). By name the word and the `move` where it is modal.
local plain, shaped = {}, {}
local in_use = plain
local plain_names, plain_moves = {}, {}   -- by the id of the word
core.set_modal_tables(state, env, plain_names, plain_moves)

-- Defines the word of such a motion. word_in_core(id) and move_in_core(id) make it and its `move` in C++; `meaning` is
-- the same in Lua, for when something stands between the word and the machine.
function motion.plain_word(name, word_in_core, move_in_core, meaning)
  local id = words.id()
  plain[name] = { name = name, word = word_in_core(id), move = move_in_core(words.id()) }
  plain_names[id], plain_moves[id] = name, plain[name].move
  shaped[name] = {}
  shaped[name].word, shaped[name].move = modal_motion(name, meaning)
  env[name] = plain[name].word
end

-- What has been defined anew since stays as it is.
local function put_in_use(motions)
  for name, word in unordered(motions) do
    if env[name] == in_use[name].word then env[name] = word.word end
  end
  local modal = motions[state.motion]
  if modal and env.move == in_use[state.motion].move then make_modal(state.motion, modal.move) end
  in_use = motions
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

-- The `move` of a motion that was modal before; which one of a plain motion is in use may have changed meanwhile.
function motion.move_in_use(name, move)
  local is_plain = plain[name] and (move == plain[name].move or move == shaped[name].move)
  return is_plain and in_use[name].move or move
end

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
local none = core.word(words.id(), function()
  alarm("mode", "axis words need a motion, and G80 has ended the one that was in force")
end)
function motion.end_motion()
  make_modal("G80", none)
end

if core.dialect == "rs274ngc" then
  motion.end_motion()   -- axis words need a motion of the program's own
else
  make_modal("G0", plain.G0.move)
end

return motion
