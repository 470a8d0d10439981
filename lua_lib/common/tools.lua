-- Tools and the offsets that belong to them: T, M6, D, H, G43, G44, G43.4, G49; M61, G43.1 and G43.2 of RS274/NGC.

local alarm, copied, given, nearly_whole = use("core/basics", "alarm", "copied", "given", "nearly_whole")
local apply_offsets = use(core.dialect == "rs274ngc" and "rs274ngc/frames" or "ab9/frames", "apply_offsets")
local word = use("core/words", "word")
local axes, frames, path, spindle, state = use "core/axes", use "common/frames", use "core/path", use "common/spindle", use "core/state"

local is_ngc = core.dialect == "rs274ngc"

-- The tool table by number: { length = mm (along Z), diameter = mm }, and offsets of other axes by their
-- letters. G10 changes it; an active offset stays as it is until it is called again.
local tool_table = {}
for number, stored in pairs(core.tools) do
  local tool = copied(stored)
  for _, field in ipairs { "length", "diameter" } do
    tool[field .. "_geometry"] = stored[field]
    tool[field] = stored[field] + (stored[field .. "_wear"] or 0)
  end
  tool_table[number] = tool
end

-- Returns a tool's length or diameter without its wear, mm.
local function tool_geometry(tool, field)
  local geometry, wear = tool[field .. "_geometry"], tool[field .. "_wear"] or 0
  if geometry and geometry + wear == tool[field] then return geometry end   -- a difference would round
  return (tool[field] or 0) - wear
end

local selected   -- by T, nil before the first one
local loaded = 0

-- Return the number of the tool in the spindle, or of the selected one; 0: no tool.
local function current_tool() return loaded end
local function selected_tool() return selected or 0 end

local MAX_NAMED = 10

local function known_tool_numbers()
  local numbers = {}
  for number in pairs(tool_table) do numbers[#numbers + 1] = number end
  table.sort(numbers)
  if #numbers == 0 then return "it is empty; tools are given in section TOOL of the machine data" end
  local more = #numbers > MAX_NAMED and (" and %d more"):format(#numbers - MAX_NAMED) or ""
  return "it has " .. table.concat(numbers, ", ", 1, math.min(#numbers, MAX_NAMED)) .. more
end

-- Returns the entry of a number that a word `name` gives; 0 has no entry. Without any table lengths are 0,
-- but a required diameter must be known.
local function tool_entry(number, name)
  if number == 0 then return nil end
  local tool = tool_table[number]
  if tool == nil and next(tool_table) == nil and name ~= "D" then
    core.warn("there is no tool table (section TOOL of the machine data): all tools have the length 0")
    return nil
  end
  if tool == nil then
    alarm("tool", "%s%d: there is no such number in the tool table; %s", name, number, known_tool_numbers())
  end
  return tool
end

local function whole(value, name)
  value = nearly_whole(value)
  if type(value) ~= "number" or value % 1 ~= 0 or value < 0 or value > 2^31 - 1 then
    alarm("word-value", "%s is a whole number from 0 on, not %s", name, tostring(value))
  end
  return math.tointeger(value)
end

local function tool_length_mm(number)
  local tool = tool_entry(number, "H")
  return tool and tool.length or 0
end

local function tool_diameter_mm(number)
  local tool = tool_entry(number, "D")
  return tool and tool.diameter or 0
end

word("T", function(value)
  if not given(value, "T") then return end
  local number = whole(value, "T")
  -- on the 9/Series T is a pocket, and offsets have numbers of their own
  if is_ngc then tool_entry(number, "T") end
  selected = number
  path.event("tool_select", ("T%d"):format(number))
end)

-- A tool change stops the spindle, if it turns.
word("M6", function()
  if is_ngc and state.spindle ~= nil then spindle.turn(nil) end
  loaded = selected or loaded
  path.event("tool_change", (is_ngc or selected ~= nil) and ("T%d"):format(loaded) or "")
end)

word("D", function(value)
  if given(value, "D") then state.offset_number_d = whole(value, "D") end
end)

-- Sets the offsets of all axes, by their letters.
local function set_active_offset(offset)
  if core.tip_control() then
    path.flush()
    core.set_tip_control(nil)
  end
  state.tool_offset = offset
  path.act(function() core.set_tool_offset(offset.x, offset.y, offset.z) end)
  apply_offsets()
end

local function tool_offsets(number, name)
  local offset = {}
  local tool = tool_entry(number, name)
  if tool == nil then return offset end
  for letter in pairs(axes.is_rotary) do offset[letter] = tool[letter] end
  offset.z = (tool.z or 0) + (tool.length or 0)
  return offset
end

local function read_h(words, name)
  if words == nil or words.h == nil then return nil end
  local number = whole(words.h, "H")
  if number == 0 and is_ngc then return nil end   -- as without H: the tool in the spindle
  return number
end

-- G43.4: X, Y and Z are the TCP, in the work, whatever the rotary axes do (TcpFrame). The length applies
-- along the tool, so that the frame has no length offset.
local function tip_control(offset)
  for letter, value in pairs(offset) do
    if value ~= 0 and not ("xyz"):find(letter, 1, true) then
      alarm("tool", "G43.4: the tool has an offset along %s; only those along X, Y and Z turn with it", letter:upper())
    end
  end
  set_active_offset({})
  path.flush()
  core.set_tip_control(offset)
  core.set_tool_offset(offset.x, offset.y, offset.z)   -- zones are at the same positions as with G43
end

local function off()
  state.length_sign = nil
  set_active_offset({})
end
word("G49", off)

-- 9/Series: the length of offset H is added along Z (G43) or subtracted (G44), as long as one of them is
-- active. H alone calls another number.
local function apply_length()
  if state.length_sign == "tip" then return tip_control({ z = tool_length_mm(state.offset_number_h or 0) }) end
  set_active_offset({ z = state.length_sign * tool_length_mm(state.offset_number_h or 0) })
end

local function length_offset(name, sign)
  word(name, function(words)
    state.offset_number_h = read_h(words, name) or state.offset_number_h
    state.length_sign = sign
    apply_length()
  end)
end

local function define_ab9_tcp_control()
  word("G43_4", function(words)
    state.offset_number_h = read_h(words, "G43.4") or state.offset_number_h
    state.length_sign = "tip"
    apply_length()
  end)
end

word("H", function(value)
  if not given(value, "H") then return end
  state.offset_number_h = whole(value, "H")
  if state.length_sign ~= nil then apply_length() end
end)

-- RS274/NGC: offsets of any axes, of a tool or as written.
local function define_ngc_words()
  word("G43", function(words)
    set_active_offset(tool_offsets(read_h(words, "G43") or loaded, "H"))
  end)

  word("G43_4", function(words)
    tip_control(tool_offsets(read_h(words, "G43.4") or loaded, "H"))
  end)

  -- Axes that are not named keep their offset.
  word("G43_1", function(words)
    local offset = copied(state.tool_offset)
    frames.each_axis(words or {}, "G43.1", "", function(letter, value) offset[letter] = value end)
    set_active_offset(offset)
  end)

  word("G43_2", function(words)
    local number = read_h(words, "G43.2")
    local offset = copied(state.tool_offset)
    local function add(letter, value) offset[letter] = (offset[letter] or 0) + value end
    local named = frames.each_axis(words or {}, "G43.2", " h ", add)
    if named == (number ~= nil) then
      alarm("tool", "G43.2 adds the offset of a tool (H), or those of its axis words")
    end
    if number ~= nil then
      for letter, value in pairs(tool_offsets(number, "H")) do add(letter, value) end
    end
    set_active_offset(offset)
  end)

  -- M61 sets the tool that is in the spindle already, without a change.
  word("M61", function(words)
    if words == nil or words.q == nil then
      alarm("word-missing", "M61 needs Q, the number of the tool in the spindle")
    end
    local number = whole(words.q, "Q of M61")
    tool_entry(number, "Q")
    loaded = number
    path.event("tool_number", ("T%d"):format(number))
  end)
end

if is_ngc then
  define_ngc_words()
else
  length_offset("G43", 1)
  length_offset("G44", -1)
  define_ab9_tcp_control()
end

return {
  by_number = tool_table, geometry = tool_geometry, diameter_mm = tool_diameter_mm, loaded = current_tool,
  selected = selected_tool,
}
