-- System variables: data of the controller that the program reads and sets by numbers from #1000 on. Lengths
-- are in program units, axes count in the order of the machine file.

local dialect = use "core/dialect"
local alarm = use("core/basics", "alarm")
local ab9_data, ab9_frames, ab9_home, ab9_modal, ab9_transform =
  dialect.use "data", dialect.use "frames", dialect.use "home", dialect.use "modal", dialect.use "transform"
local axes, inputs, path, state = use "core/axes", use "common/inputs", use "core/path", use "core/state"

local MAX_AXES = 12
local LAST_TOOL = 200
local FIRST_EXTERNAL = 5201
local HOUR_S = 3600
local DAY_S = 86400

local ranges = {}   -- { first, last, what, get = function(number, index), set = function(number, value, index) or nil }

local function range(first, last, what, get, set)
  ranges[#ranges + 1] = { first = first, last = last, what = what, get = get, set = set }
end

-- Lengths and axes ------------------------------------------------------------------------------------------------------

local function axis_letter(number, index)
  local axis = axes.list[index + 1]
  if axis == nil then alarm("axis", "#%d: the machine has %d axes", number, #axes.list) end
  return axis.letter
end

-- Variables of the axes: get and set use mm or deg.
local function axis_range(first, what, get, set)
  range(first, first + MAX_AXES - 1, what, function(number, index)
    local letter = axis_letter(number, index)
    return axes.in_program_units(letter, get(letter))
  end, set and function(number, value, index)
    local letter = axis_letter(number, index)
    set(letter, axes.in_mm(letter, value))
  end)
end

-- Inputs and outputs ----------------------------------------------------------------------------------------------------

local SIGNAL_COUNT = 32       -- #1032 and #1132: the 32 signals before as one number

local outputs = {}   -- number from 0 -> true if it is on

-- on_input(f): f("digital", number) returns the value of input `number`, which the program reads as #1000 +
-- number.
local function input_is_on(number)
  local handler = inputs.handler
  local signal = handler == nil and inputs.input_value("DI", number)
  if handler == nil and signal ~= nil then return signal == true or (signal and signal ~= 0) end
  if handler == nil then
    core.warn("inputs (#1000 on) are read as 0; a script defines them with on_input(function(kind, number) return 1 end)")
    return false
  end
  local value = handler("digital", number)
  if value == nil or type(value) == "boolean" then return value == true end
  if type(value) ~= "number" then alarm("script", "the function of on_input must return a number, true, false or nil") end
  return value ~= 0
end

local function switch_output(number, on)
  outputs[number] = on or nil
  path.event("digital_output", ("P%d %s"):format(number, on and "on" or "off"))
  inputs.set_output("DO", number, on)
end

local function signals(first, what, is_on, switch)
  range(first, first + SIGNAL_COUNT, what, function(_, index)
    if index < SIGNAL_COUNT then return is_on(index) and 1.0 or 0.0 end
    local bits = 0
    for number = 0, SIGNAL_COUNT - 1 do bits = bits | (is_on(number) and 1 << number or 0) end
    return bits + 0.0
  end, switch and function(number, value, index)
    if index < SIGNAL_COUNT then return switch(index, value ~= 0) end
    local bits = math.tointeger(value)
    if bits == nil or bits < 0 or bits >= 1 << SIGNAL_COUNT then
      alarm("word-value", "#%d requires the 32 outputs as an integer", number)
    end
    for signal = 0, SIGNAL_COUNT - 1 do
      local on = bits & (1 << signal) ~= 0
      if on ~= (outputs[signal] == true) then switch(signal, on) end
    end
  end)
end
signals(1000, "inputs", input_is_on)
signals(1100, "outputs", function(number) return outputs[number] == true end, switch_output)

-- Tool offsets ----------------------------------------------------------------------------------------------------------

local function tool_range(first, field, part, what)
  range(first, first + LAST_TOOL - 1, what, function(_, index)
    return ab9_data.tool_component(index + 1, field, part) / core.unit_mm()
  end, function(_, value, index)
    ab9_data.set_tool_component(index + 1, field, part, value * core.unit_mm())
  end)
end
tool_range(2001, "length", "geometry", "lengths of tools")
tool_range(2201, "length", "wear", "wear of their lengths")
tool_range(2401, "diameter", "geometry", "diameters of tools")
tool_range(2601, "diameter", "wear", "wear of their diameters")

-- Alarm, timers, messages, clock ----------------------------------------------------------------------------------------

local timer_from = { [3001] = 0, [3002] = 0 }
local timer_unit_s = { [3001] = 0.001, [3002] = HOUR_S }
local blocks = { [3003] = 0.0, [3004] = 0.0 }

local function with_text(text) return text and text ~= "" and (" (" .. text .. ")") or "" end

range(3000, 3000, "alarm", nil, function(_, value, _, text)
  alarm("program-alarm", "the program raises its alarm %.10g%s", value, with_text(text))
end)

range(3001, 3002, "timers in ms and in hours", function(number)
  return (core.time() - timer_from[number]) / timer_unit_s[number]
end, function(number, value)
  timer_from[number] = core.time() - value * timer_unit_s[number]
end)

range(3003, 3004, "control of single blocks, feed hold and override", function(number) return blocks[number] end,
  function(number, value)
    blocks[number] = value
    core.warn(("#%d is set, but has no effect: single blocks, feed hold and overrides do not exist here")
      :format(number))
  end)

range(3006, 3006, "stop with a message", nil, function(_, value, _, text)
  path.event("stop", ("#3006=%.10g%s"):format(value, with_text(text)))
end)

range(3007, 3007, "mirrored axes, 1 for the first, 2 for the second, 4 for the third ..", function()
  local bits = 0
  for index, axis in ipairs(axes.list) do
    if ab9_transform.mirrored_axes()[axis.letter] then bits = bits + (1 << (index - 1)) end
  end
  return bits + 0.0
end)

-- The clock of a run starts on 1 January 2001 at midnight and runs with the machine's time.
local MONTHS = { 31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31 }

local function is_leap(year) return year % 4 == 0 and (year % 100 ~= 0 or year % 400 == 0) end

local function date_after(days)
  local year, month = 2001, 1
  while days >= (is_leap(year) and 366 or 365) do
    days = days - (is_leap(year) and 366 or 365)
    year = year + 1
  end
  local function length() return MONTHS[month] + (month == 2 and is_leap(year) and 1 or 0) end
  while days >= length() do
    days = days - length()
    month = month + 1
  end
  return year * 10000 + month * 100 + days + 1
end

range(3011, 3012, "date YYYYMMDD and time HHMMSS", function(number)
  local seconds = math.floor(core.time())
  if number == 3011 then return date_after(seconds // DAY_S) + 0.0 end
  local today = seconds % DAY_S
  return (today // HOUR_S * 10000 + today % HOUR_S // 60 * 100 + today % 60) + 0.0
end)

-- Modal codes -----------------------------------------------------------------------------------------------------------

range(4001, 4120, "modal codes and the last F, S, T, D, H and M", function(number)
  local value, known = ab9_modal.modal_code(number)
  if not known then
    alarm("variable",
      "#%d is not defined on this controller; use #4001 to #4017 and #4022 (modal groups), #4107 (D), #4109 (F), "
      .. "#4111 (H), #4113 (M), #4119 (S) and #4120 (T)", number)
  end
  return value and value + 0.0
end)

-- Positions and offsets -------------------------------------------------------------------------------------------------

axis_range(5001, "end of the last block", function(letter)
  return core.to_program(axes.display_point((core.target(nil))))[letter]
end)
axis_range(5021, "machine position", function(letter) return axes.display_point(axes.machine_point())[letter] end)
axis_range(5041, "position in the work coordinate system", function(letter)
  return core.to_program(axes.display_point(axes.machine_point()))[letter]
end)
axis_range(5061, "position of the last skip (G31)", function(letter)
  local point = ab9_home.skip_position()
  if point == nil then alarm("variable", "there is no skip position before the first G31") end
  return core.to_program(point)[letter]
end)
axis_range(5081, "active tool offset", function(letter) return state.tool_offset[letter] or 0 end)
axis_range(5101, "following error, which is 0 here", function() return 0 end)
axis_range(FIRST_EXTERNAL, "offset of all work coordinate systems", ab9_transform.external_offset,
  ab9_transform.set_external_offset)

for index, code in ipairs { "54", "55", "56", "57", "58", "59", "59.1", "59.2", "59.3" } do
  axis_range(FIRST_EXTERNAL + 20 * index, "zero point of G" .. code,
    function(letter) return ab9_frames.work_offset(code, letter) end,
    function(letter, value) ab9_data.set_work_offset(code, letter, value) end)
end

-- Access ----------------------------------------------------------------------------------------------------------------

local function find(number)
  for _, entry in ipairs(ranges) do
    if number >= entry.first and number <= entry.last then return entry end
  end
end

local system = {}

-- Known variables, for the alarm of a number that does not exist.
system.NUMBERS = "the system variables #1000 to #1032 (inputs), #1100 to #1132 (outputs), #2001 to #2800 (tool offsets), #3000 "
    .. "to #3004, #3006, #3007, #3011 and #3012 (alarm, timers, messages, clock), #4001 to #4120 (modal codes), and by axis "
    .. "from #5001, #5021, #5041, #5061, #5081 and #5101 (positions) and #5201, #5221 .. #5381 on (zero points)"

-- system.get(number) -> true, value; nil if no variable has that number.
function system.get(number)
  local entry = find(number)
  if entry == nil then return nil end
  if entry.get == nil then alarm("variable", "#%d (%s) can only be set", number, entry.what) end
  return true, entry.get(number, number - entry.first)
end

-- system.set(number, value, text) -> true; `text` is the remark of the block, for #3000 and #3006.
function system.set(number, value, text)
  local entry = find(number)
  if entry == nil then return nil end
  if entry.set == nil then alarm("variable", "#%d (%s) can only be read", number, entry.what) end
  if value == nil then value = 0 end
  if type(value) ~= "number" then alarm("script", "#%d must be a number", number) end
  core.note_place()   -- for events, because an assignment is no word with a source location
  entry.set(number, value, number - entry.first, text)
  return true
end

-- The offset of all work coordinate systems is stored too; in machine data it is stored as its variables.
local function for_each_external_offset(use)
  for index, axis in ipairs(axes.list) do
    if index <= MAX_AXES and ("xyz"):find(axis.letter, 1, true) then use(FIRST_EXTERNAL + index - 1, axis.letter) end
  end
end

for_each_external_offset(function(number, letter)
  local value = core.variables[number]
  if value then ab9_transform.set_external_offset(letter, value) end
end)

function system.store(stored)
  for_each_external_offset(function(number, letter)
    local value = ab9_transform.external_offset(letter)
    if value ~= 0 or stored[number] then stored[number] = value end
  end)
end

return system
