-- Tools and the offsets that belong to them: T, M6, D, H, G49. The words that switch offsets on differ between
-- the dialects (tool_offsets.lua).

local alarm, copied, given, snap_to_integer = use("core/basics", "alarm", "copied", "given", "snap_to_integer")
local dialect = use "core/dialect"
local apply_offsets = dialect.use("frames", "apply_offsets")
local word = use("core/words", "word")
local axes, path, spindle, state = use "core/axes", use "core/path", use "common/spindle", use "core/state"

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

-- Return the number of the tool in the spindle, or of the selected one; 0: no tool. load_tool() sets the first.
local function current_tool() return loaded end
local function load_tool(number) loaded = number end
local function selected_tool() return selected or 0 end

local MAX_NAMED = 10

local function known_tool_numbers()
  local numbers = {}
  for number in pairs(tool_table) do numbers[#numbers + 1] = number end
  table.sort(numbers)
  if #numbers == 0 then return "it is empty; tools are defined in section TOOL of the machine data" end
  local more = #numbers > MAX_NAMED and (" and %d more"):format(#numbers - MAX_NAMED) or ""
  return "it has " .. table.concat(numbers, ", ", 1, math.min(#numbers, MAX_NAMED)) .. more
end

-- Returns the entry of a number that a word `name` gives; 0 has no entry. Without any table lengths are 0,
-- but a required diameter must be known.
local function tool_entry(number, name)
  if number == 0 then return nil end
  local tool = tool_table[number]
  if tool == nil and next(tool_table) == nil and name ~= "D" then
    core.warn("the tool table (section TOOL of the machine data) is missing: all tools have length 0")
    return nil
  end
  if tool == nil then
    alarm("tool", "%s%d: this number is not in the tool table; %s", name, number, known_tool_numbers())
  end
  return tool
end

local function whole(value, name)
  value = snap_to_integer(value)
  if type(value) ~= "number" or value % 1 ~= 0 or value < 0 or value > 2^31 - 1 then
    alarm("word-value", "%s must be an integer of at least 0, not %s", name, tostring(value))
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
  if dialect.tools_by_number then tool_entry(number, "T") end
  selected = number
  path.event("tool_select", ("T%d"):format(number))
end)

word("M6", function()
  if dialect.tool_change_stops_spindle and state.spindle ~= nil then spindle.turn(nil) end
  loaded = selected or loaded
  path.event("tool_change", (dialect.names_unselected_tool or selected ~= nil) and ("T%d"):format(loaded) or "")
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
  if number == 0 and dialect.h0_is_spindle_tool then return nil end
  return number
end

-- G43.4: X, Y and Z are the TCP, in the work, whatever the rotary axes do (TcpFrame). The length applies
-- along the tool, so that the frame has no length offset.
local function tip_control(offset)
  for letter, value in pairs(offset) do
    if value ~= 0 and not ("xyz"):find(letter, 1, true) then
      alarm("tool", "G43.4: the tool has an offset along %s; only offsets along X, Y and Z turn with it", letter:upper())
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

word("H", function(value)
  if not given(value, "H") then return end
  state.offset_number_h = whole(value, "H")
  if state.length_sign ~= nil then apply_length() end
end)

return {
  by_number = tool_table, geometry = tool_geometry, diameter_mm = tool_diameter_mm, loaded = current_tool,
  selected = selected_tool, load = load_tool, entry = tool_entry, number = whole, offsets = tool_offsets,
  read_h = read_h, set_active_offset = set_active_offset, tip_control = tip_control, apply_length = apply_length,
}
