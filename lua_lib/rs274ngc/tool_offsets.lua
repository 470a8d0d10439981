-- Tool offsets of any axes, of a tool or as written: G43, G43.1, G43.2, G43.4; M61.

local alarm, copied = use("core/basics", "alarm", "copied")
local frames, path, state, tools = use "common/frames", use "core/path", use "core/state", use "common/tools"
local word = use("core/words", "word")

word("G43", function(words)
  tools.set_active_offset(tools.offsets(tools.read_h(words, "G43") or tools.loaded(), "H"))
end)

word("G43_4", function(words)
  tools.tip_control(tools.offsets(tools.read_h(words, "G43.4") or tools.loaded(), "H"))
end)

-- Axes that are not named keep their offset.
word("G43_1", function(words)
  local offset = copied(state.tool_offset)
  frames.each_axis(words or {}, "G43.1", "", function(letter, value) offset[letter] = value end)
  tools.set_active_offset(offset)
end)

word("G43_2", function(words)
  local number = tools.read_h(words, "G43.2")
  local offset = copied(state.tool_offset)
  local function add(letter, value) offset[letter] = (offset[letter] or 0) + value end
  local named = frames.each_axis(words or {}, "G43.2", " h ", add)
  if named == (number ~= nil) then
    alarm("tool", "G43.2 adds either the offset of a tool (H) or the offsets of its axis words")
  end
  if number ~= nil then
    for letter, value in pairs(tools.offsets(number, "H")) do add(letter, value) end
  end
  tools.set_active_offset(offset)
end)

-- M61 sets the tool that is in the spindle already, without a change.
word("M61", function(words)
  if words == nil or words.q == nil then
    alarm("word-missing", "M61 needs Q, the number of the tool in the spindle")
  end
  local number = tools.number(words.q, "Q of M61")
  tools.entry(number, "Q")
  tools.load(number)
  path.event("tool_number", ("T%d"):format(number))
end)
