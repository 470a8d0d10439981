-- Remembers for the system variables #4001 to #4120 which code of each modal group, and which word of each letter, came
-- last.

local printed = use("basics", "printed")
local ab9_macros, cycles, state, words = use "ab9_macros", use "cycles", use "state", use "words"

local group_of = {}   -- group -> names of its codes
local numbers = {}    -- group -> number in force

local function group(index, initial, names)
  group_of[index], numbers[index] = names, initial
end

-- Groups by the last two digits of their variable, with what is in force when a run begins. Group 1 is the modal motion.
group(2, 17, { "G17", "G18", "G19" })
group(3, 90, { "G90", "G91" })
group(4, 23, { "G22", "G23" })
group(5, 94, { "G93", "G94", "G95" })
group(6, state.unit_mm == 1 and 21 or 20, { "G20", "G21" })
group(7, 40, { "G40", "G41", "G42" })
group(8, 49, { "G43", "G43_4", "G44", "G49" })
group(9, 80, { "G73", "G74", "G76", "G80", "G81", "G82", "G83", "G84", "G85", "G86", "G87", "G88", "G89" })
group(10, 98, { "G98", "G99" })
group(13, 97, { "G96", "G97" })
group(16, 69, { "G68", "G69" })
group(17, 15, { "G15", "G16" })
group(22, 50.1, { "G50_1", "G51_1" })

local last = {}   -- letter -> value of the last word F, S, T, D, H or M

local function code_number(name) return tonumber(printed(name:sub(2))) end

for index, names in pairs(group_of) do
  for _, name in ipairs(names) do
    local number = code_number(name)
    words.before(name, "modal codes", function() numbers[index] = number end)
  end
end

-- Bare, both codes of scaling end it.
numbers[11] = 14
words.before({ "G14", "G14_1" }, "modal codes", function(_, given)
  numbers[11] = given ~= nil and next(given) ~= nil and 14.1 or 14
end)

words.before({ "F", "S", "T", "D", "H" }, "modal codes", function(name, value) last[name] = value or last[name] end)
for _, number in ipairs { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 19, 30, 48, 49, 98, 99 } do
  words.before("M" .. number, "modal codes", function() last.M = number end)
end

-- Codes whose state is kept elsewhere.
local kept_elsewhere = {
  [1] = function()
    local number = state.motion ~= "CIP" and code_number(state.motion)
    return number and number < 70 and number or 0
  end,
  [9] = function()
    local number = cycles.is_cycle(state.motion) and code_number(state.motion)
    return number or 80
  end,
  [12] = function() return ab9_macros.modal_code() end,
  [14] = function() return tonumber(state.frame) end,
  [15] = function() return state.path_mode end,
}

local letters = { [7] = "D", [9] = "F", [11] = "H", [13] = "M", [19] = "S", [20] = "T" }

-- #4001 to #4022: the code of a group; #4107 .. #4120: the last word of a letter, vacant before the first one. The second
-- result is nil where the control has no such group or letter.
local function modal_code(variable)
  local index = variable - 4000
  if kept_elsewhere[index] then return kept_elsewhere[index](), true end
  if numbers[index] ~= nil then return numbers[index], true end
  local letter = letters[index - 100]
  if letter then return last[letter], true end
  return nil, nil
end

return { modal_code = modal_code }
