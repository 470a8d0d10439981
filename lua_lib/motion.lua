-- Rapid and linear moves and the modal motion.

-- Makes `name` the modal motion: `move` goes on with `meaning`.
function make_modal(name, meaning)
  state.motion = name
  core.forget_modal_word()
  env.move = meaning
end

-- A motion that becomes modal, and what `move` then is: the same without the change of mode.
local function modal_motion(name, meaning)
  local modal = core.word(word_id(), meaning)
  local motion = core.word(word_id(), function(words)
    make_modal(name, modal)
    meaning(words)
  end)
  return motion, modal
end

-- Defines the word of a motion that is modal.
function modal_word(name, meaning)
  env[name] = modal_motion(name, with_known_keys(name, meaning))
end

-- Plain motions are C++ as long as nothing shapes them: polar programming, a filter, a modal macro call. By name the
-- word and the `move` where it is modal.
local plain, shaped = {}, {}
local in_use = plain
local plain_names, plain_moves = {}, {}   -- by the id of the word
core.set_modal_tables(state, env, plain_names, plain_moves)
local reasons = {}

-- Defines the word of such a motion. word_in_core(id) and move_in_core(id) make it and its `move` in C++; `meaning` is
-- the same in Lua, for when something stands between the word and the machine.
function plain_word(name, word_in_core, move_in_core, meaning)
  local id = word_id()
  plain[name] = { name = name, word = word_in_core(id), move = move_in_core(word_id()) }
  plain_names[id], plain_moves[id] = name, plain[name].move
  shaped[name] = {}
  shaped[name].word, shaped[name].move = modal_motion(name, meaning)
  env[name] = in_use[name].word
end

-- What has been defined anew since stays as it is.
local function use(motions)
  if in_use == motions then return end
  for name, motion in pairs(motions) do
    if env[name] == in_use[name].word then env[name] = motion.word end
  end
  local modal = motions[state.motion]
  if modal and env.move == in_use[state.motion].move then make_modal(state.motion, modal.move) end
  in_use = motions
end

-- The `move` of a motion that was modal before; which one of a plain motion is in use may have changed meanwhile.
function move_in_use(name, move)
  local is_plain = plain[name] and (move == plain[name].move or move == shaped[name].move)
  return is_plain and in_use[name].move or move
end

function shape(reason, on)
  reasons[reason] = on or nil
  use(next(reasons) ~= nil and shaped or plain)
end

local function line(name, rapid)
  local function line_in_lua(words)
    check_table(words, name)
    if words == nil then return end
    local target, named = core.target(resolve_words(words))
    if not named then return end
    if rapid then path.rapid(target) else path.line(target) end
  end
  plain_word(name, function(id) return core.line_word(rapid, id) end,
    function(id) return core.modal_line_word(rapid, id) end, line_in_lua)
end
line("G0", true)
line("G1", false)
make_modal("G0", plain.G0.move)

-- No motion is modal: axis words need one.
local none = core.word(word_id(), function()
  alarm("mode", "axis words need a motion, and G80 has ended the one that was in force")
end)
function end_motion()
  make_modal("G80", none)
end
