-- Rapid and linear moves, the modal motion, and the home position.

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

core.on_modal_line(function(rapid)
  state.motion = rapid and "G0" or "G1"
  env.move = plain_move[state.motion]
end)

-- Plain words, in C++ (polar programming puts others in their place).
function use_plain_lines()
  env.G0, env.G1 = plain.G0, plain.G1
  if plain_move[state.motion] then
    core.forget_modal_line()
    env.move = plain_move[state.motion]
  end
end
use_plain_lines()

-- Home: G28 goes there by a point on the way, G29 comes back by the same point, G27 checks.
local way

local increment = { x = "u", y = "v", z = "w" }

local function named_axes(words)
  local names = {}
  for _, axis in ipairs(axes) do
    local letter = axis.letter
    if words == nil or words[letter] ~= nil or words[increment[letter]] ~= nil then names[#names + 1] = axis end
  end
  return names
end

word("G28", function(words)
  check_table(words, "G28")
  if words ~= nil then
    way = core.target(words)
    core.rapid_to(way)
  else
    way = nil
  end
  local home = {}
  for _, axis in ipairs(named_axes(words)) do home[axis.letter] = axis.home end
  core.rapid_to(home)
end)

word("G29", function(words)
  check_table(words, "G29")
  if words == nil then alarm("G29 needs the axis words of its target") end
  local target = core.target(words)
  if way ~= nil then core.rapid_to(way) end
  core.rapid_to(target)
end)

word("G27", function(words)
  check_table(words, "G27")
  if words ~= nil then core.rapid_to(core.target(words)) end
  for _, axis in ipairs(named_axes(words)) do
    local position = core.position(axis.letter)
    if math.abs(position - axis.home) > 1e-6 then
      alarm("G27: axis %s stands at %.10g, not at its home %.10g", axis.letter:upper(), position, axis.home)
    end
  end
end)
