-- Rapid and linear moves and the modal motion.

local plain = {
  G0 = core.line_word(true, word_id()),
  G1 = core.line_word(false, word_id()),
}
local plain_move = {
  G0 = core.modal_line_word(true, word_id()),
  G1 = core.modal_line_word(false, word_id()),
}

-- Makes `name` the modal motion: `move` goes on with `meaning`.
function make_modal(name, meaning)
  state.motion = name
  core.forget_modal_line()
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
  env[name] = modal_motion(name, meaning)
end

core.on_modal_line(function(rapid)
  state.motion = rapid and "G0" or "G1"
  env.move = plain_move[state.motion]
end)

-- The same words in Lua, for when something stands between a straight line and the machine.
local function line_in_lua(rapid)
  return function(words)
    check_table(words, rapid and "G0" or "G1")
    if words == nil then return end
    local target, named = core.target(resolve_words(words))
    if not named then return end
    if rapid then path.rapid(target) else path.line(target) end
  end
end

local shaped, shaped_move = {}, {}
shaped.G0, shaped_move.G0 = modal_motion("G0", line_in_lua(true))
shaped.G1, shaped_move.G1 = modal_motion("G1", line_in_lua(false))

-- Plain lines are C++ as long as nothing shapes them: polar programming, a filter, a modal macro call.
local reasons = {}

local function use(lines, moves)
  if env.G0 == lines.G0 then return end
  env.G0, env.G1 = lines.G0, lines.G1
  if plain_move[state.motion] then make_modal(state.motion, moves[state.motion]) end
end

function shape(reason, on)
  reasons[reason] = on or nil
  if next(reasons) ~= nil then use(shaped, shaped_move) else use(plain, plain_move) end
end
use(plain, plain_move)

-- No motion is modal: axis words need one.
local none = core.word(word_id(), function()
  alarm("axis words need a motion, and G80 has ended the one that was in force")
end)
function end_motion()
  make_modal("G80", none)
end
