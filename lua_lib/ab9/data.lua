-- Data setting (G10): L2 and L20 work coordinate systems, L10 to L13 the tables of tool offsets. G90: the
-- value itself, G91: added to the value in the table. An active tool offset stays as it is until it is called
-- again.

local dialect = use "core/dialect"
local alarm = use("core/basics", "alarm")
local word = use("core/words", "word")
local ab9_frames, ab9_transform, frames, tools = dialect.use "frames", dialect.use "transform", use "common/frames", use "common/tools"

local LAST_TOOL = 999
local FIRST_SETTABLE, LAST_SETTABLE = 505, 599

-- G10 L2 P1 .. P9.
local systems = { "54", "55", "56", "57", "58", "59", "59.1", "59.2", "59.3" }

local tables = {
  [10] = { field = "length", part = "geometry", what = "the length" },
  [11] = { field = "length", part = "wear", what = "the wear of the length" },
  [12] = { field = "diameter", part = "geometry", what = "the diameter" },
  [13] = { field = "diameter", part = "wear", what = "the wear of the diameter" },
}

local function whole(words, letter, least, most)
  local value = words[letter]
  local number = type(value) == "number" and math.tointeger(math.floor(value + 0.5))
  if not number or math.abs(value - number) > 1e-6 or number < least or number > most then
    alarm("word-value", "G10: %s must be an integer from %d to %d, not %s", letter:upper(), least, most,
      value == nil and "a missing value" or tostring(value))
  end
  return number
end

local function new_value(old, value) return core.is_incremental() and (old or 0) + value or value end

local function set_axes(words, set)
  if not frames.each_axis(words, "G10", " l p ", set) then
    alarm("word-missing", "G10 requires the axis words that it sets")
  end
end

local function set_work_offset(code, letter, value)
  core.offsets[code] = core.offsets[code] or {}
  core.offsets[code][letter] = value
  ab9_frames.refresh_frame(code)
end

local function set_system(code, words)
  set_axes(words, function(letter, value)
    set_work_offset(code, letter, new_value(ab9_frames.work_offset(code, letter), value))
  end)
end

local function set_work_system(words)
  local number = whole(words, "p", 0, #systems)
  if number == 0 then
    set_axes(words, function(letter, value)
      ab9_transform.set_external_offset(letter, new_value(ab9_transform.external_offset(letter), value))
    end)
  else
    set_system(systems[number], words)
  end
end

-- Sets the settable frames by their number: 1 to 4 are G54 to G57, 5 to 99 are G505 to G599.
local function set_settable_frame(words)
  local number = whole(words, "p", 1, LAST_SETTABLE - 500)
  local code = number <= 4 and systems[number] or tostring(math.max(500 + number, FIRST_SETTABLE))
  set_system(code, words)
end

-- Returns one part of a tool's length or diameter: "geometry" or "wear", mm.
local function tool_component(number, field, part)
  local tool = tools.by_number[number]
  if tool == nil then return 0 end
  return part == "wear" and (tool[field .. "_wear"] or 0) or tools.geometry(tool, field)
end

-- The active offset is the sum of both parts.
local function set_tool_component(number, field, part, value)
  local tool = tools.by_number[number]
  if tool == nil then
    tool = { length = 0, diameter = 0 }
    tools.by_number[number] = tool
  end
  local geometry, wear = tool_component(number, field, "geometry"), tool_component(number, field, "wear")
  if part == "wear" then wear = value else geometry = value end
  tool[field], tool[field .. "_geometry"], tool[field .. "_wear"] = geometry + wear, geometry, wear
end

local function tool_offset(words, place)
  local number = whole(words, "p", 1, LAST_TOOL)
  for key in pairs(words) do
    if key ~= "l" and key ~= "p" and key ~= "r" then
      alarm("word-out-of-place", "G10 L%d sets %s of offset P by R; it does not accept the word %s", words.l, place.what,
        tostring(key):upper())
    end
  end
  if type(words.r) ~= "number" then
    alarm("word-missing", "G10 L%d requires R, %s in program units", words.l, place.what)
  end
  local old = tool_component(number, place.field, place.part)
  set_tool_component(number, place.field, place.part, new_value(old, words.r * core.unit_mm()))
end

word("G10", function(words)
  if words == nil or words.l == nil then
    alarm("word-missing", "G10 requires L: L2 (work coordinate systems), L20 (settable frames), L10 to L13 (tool offsets)")
  end
  local list = whole(words, "l", 0, 99)
  if list == 2 then
    set_work_system(words)
  elseif list == 20 then
    set_settable_frame(words)
  elseif tables[list] then
    tool_offset(words, tables[list])
  else
    alarm("word-value", "G10 L%d is not supported; use L2, L20 or L10 to L13", list)
  end
end)

-- Each G10 is complete in its block, so no mode has to be ended.
word("G11", function() end)

-- G12 is in the thesis's grammar next to G10 and G11, without any data of its own.
word("G12", function() alarm("word-value", "G12 has no effect on this controller; set data with G10") end)

return { tool_component = tool_component, set_tool_component = set_tool_component, set_work_offset = set_work_offset }
