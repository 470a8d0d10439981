-- Tool length offsets by H: G43, G44, G43.4.

local state, tools = use "core/state", use "common/tools"
local word = use("core/words", "word")

local function length_offset(name, sign)
  word(name, function(words)
    state.offset_number_h = tools.read_h(words, name) or state.offset_number_h
    state.length_sign = sign
    tools.apply_length()
  end)
end
length_offset("G43", 1)
length_offset("G44", -1)

word("G43_4", function(words)
  state.offset_number_h = tools.read_h(words, "G43.4") or state.offset_number_h
  state.length_sign = "tip"
  tools.apply_length()
end)
