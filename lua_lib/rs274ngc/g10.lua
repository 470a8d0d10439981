-- RS274/NGC: G10 sets the tool table (L1, L10, L11) and the work coordinate systems (L2, L20).

local dialect = use "core/dialect"
local alarm = use("core/basics", "alarm")
local word = use("core/words", "word")
local axes, compensation, frames, parameters = use "core/axes", use "common/compensation", use "common/frames", dialect.use "variables"
local path, state, systems, tools = use "core/path", use "core/state", dialect.use "frames", use "common/tools"

local SYSTEMS = 9
local REFERENCE_SYSTEM = 9      -- G59.3, which L11 measures by
local LAST_ORIENTATION = 9

local function reject_words(words, letters, name)
  for _, letter in ipairs(letters) do
    if words[letter] ~= nil then alarm("word-out-of-place", "%s does not accept %s", name, letter:upper()) end
  end
end

-- --- Work coordinate systems ---

local function read_system(words, name)
  local number = parameters.whole(words.p)
  if number == nil or number < 0 or number > SYSTEMS then
    alarm("word-missing", "%s needs P from 1 (G54) to %d (G59.3), or 0 for the active system", name, SYSTEMS)
  end
  if number == 0 then number = systems.active_system end
  if number == systems.active_system then compensation.refuse(name .. " for the active system") end
  return number
end

local function reload(system)
  if system == systems.active_system then systems.load(system) end
end

local function wait_at(system) path.wait_at(system == systems.active_system and "G10 L2" or "G10 L2 other") end

local function set_origin(words)
  reject_words(words, { "i", "j", "q" }, "G10 L2")
  local system = read_system(words, "G10 L2")
  wait_at(system)
  frames.each_axis(words, "G10 L2", " l p r ", function(letter, value) systems.store_origin(system, letter, value) end)
  if words.r ~= nil then systems.store_rotation(system, words.r) end
  reload(system)
end

-- Machine position without its tool offset: `carriage` in machine coordinates, `to_system` in those of a
-- system.
local function carriage()
  local point = axes.display_point(axes.programmed_point())
  for letter, value in pairs(point) do point[letter] = value - (state.tool_offset[letter] or 0) end
  return point
end

local function to_system(point, at, degrees, g92)
  local inside = {}
  for letter, value in pairs(point) do inside[letter] = value - at[letter] end
  if inside.x and inside.y then inside.x, inside.y = systems.turned(inside.x, inside.y, -degrees) end
  for letter, value in pairs(inside) do inside[letter] = value - (g92[letter] or 0) end
  return inside
end

-- L20: the origin moves so that the machine is at the given coordinates.
local function set_origin_by_position(words)
  reject_words(words, { "i", "j", "q", "r" }, "G10 L20")
  local system = read_system(words, "G10 L20")
  wait_at(system)
  local at, degrees = systems.data(system)
  local here = carriage()
  local position = to_system(here, at, degrees, state.g92)
  local any = frames.each_axis(words, "G10 L20", " l p ", function(letter, value) position[letter] = value end)
  if not any then return end
  for letter, value in pairs(systems.placed(position, {}, degrees, state.g92)) do
    systems.store_origin(system, letter, here[letter] - value)
  end
  reload(system)
end

-- --- Tool table ---

local function find_tool(words, name)
  local number = parameters.whole(words.p)
  if number == nil or number < 1 then alarm("word-missing", "%s needs P, the tool number", name) end
  return tools.by_number[number] or alarm("tool", "%s P%d: tool %d is not in the tool table", name, number, number)
end

-- Sets R, I, J and Q of a tool: radius, front and back angle, orientation.
local function set_shape(tool, words, name)
  if words.r ~= nil then tool.diameter = 2 * axes.in_mm("x", words.r) end
  tool.front_angle = words.i or tool.front_angle
  tool.back_angle = words.j or tool.back_angle
  if words.q ~= nil then
    local orientation = parameters.whole(words.q)
    if orientation == nil or orientation < 0 or orientation > LAST_ORIENTATION then
      alarm("word-value", "Q of %s (tool orientation) must be an integer from 0 to %d", name, LAST_ORIENTATION)
    end
    tool.orientation = orientation
  end
end

-- Returns the offset of a tool along an axis, mm or deg; `length` is the offset along Z.
local function tool_offset(tool, letter)
  if letter == "z" then return (tool.length or 0) + (tool.z or 0) end
  return tool[letter] or 0
end

local function set_tool_offset(tool, letter, value)
  if letter == "z" then
    tool.length, tool.z = value, nil
  else
    tool[letter] = value
  end
end

local TOOL_WORDS = " l p r i j q "

local function set_tool(words)
  local tool = find_tool(words, "G10 L1")
  path.wait_at("G10 L1")
  frames.each_axis(words, "G10 L1", TOOL_WORDS, function(letter, value) set_tool_offset(tool, letter, value) end)
  set_shape(tool, words, "G10 L1")
end

-- L10, L11: if the new offset is active (G43), the machine is at the given coordinates of the system.
local function set_tool_by_position(name, words, system, g92)
  local tool = find_tool(words, name)
  path.wait_at("G10 L1")
  local at, degrees = systems.data(system)
  local here = carriage()
  for letter, value in pairs(here) do here[letter] = value + (state.tool_offset[letter] or 0) end
  local position = to_system(carriage(), at, degrees, g92)
  local named = {}
  frames.each_axis(words, name, TOOL_WORDS, function(letter, value)
    position[letter] = value
    named[letter] = true
  end)
  if degrees ~= 0 and (named.x or named.y) then named.x, named.y = true, true end
  local tip = systems.placed(position, at, degrees, g92)
  for letter in pairs(named) do set_tool_offset(tool, letter, here[letter] - tip[letter]) end
  set_shape(tool, words, name)
end

local meanings = {
  [0] = function() path.event("tool_table", "read again: unchanged") end,
  [1] = set_tool,
  [2] = set_origin,
  [10] = function(words) set_tool_by_position("G10 L10", words, systems.active_system, state.g92) end,
  [11] = function(words) set_tool_by_position("G10 L11", words, REFERENCE_SYSTEM, {}) end,
  [20] = set_origin_by_position,
}

word("G10", function(words)
  local meaning = words and meanings[parameters.whole(words.l) or -1]
  if meaning == nil then
    alarm("word-missing", "G10 needs L: 1, 10 or 11 for tools, 2 or 20 for work coordinate systems")
  end
  meaning(words)
end)

-- #5400 to #5413: the tool in the spindle.
local function loaded() return tools.by_number[tools.loaded()] or {} end

parameters.compute(5400, function() return tools.loaded() end)
for i, letter in ipairs(parameters.letters) do
  parameters.compute(5400 + i, function() return parameters.to_stored(letter, tool_offset(loaded(), letter)) end)
end
parameters.compute(5410, function() return parameters.to_stored("x", loaded().diameter or 0) end)
parameters.compute(5411, function() return loaded().front_angle or 0 end)
parameters.compute(5412, function() return loaded().back_angle or 0 end)
parameters.compute(5413, function() return loaded().orientation or 0 end)
