-- Stores for the system variables #4001 to #4120 the last code of each modal group, and the last word of each
-- letter.

local dialect = use "core/dialect"
local code_number = use("core/basics", "code_number")
local ab9_macros, cycles, state, words = dialect.use "macros", use "common/cycles", use "core/state", use "core/words"

-- Groups of the dialect's table by the last two digits of their variable, and the numbers of the last codes;
-- initially those that are active at the start of a run. Group 1 is the modal motion.
local variable_by_key = {
  plane = 2, ["distance mode"] = 3, ["programmable zone"] = 4, ["feed mode"] = 5, units = 6, ["cutter compensation"] = 7,
  ["tool length"] = 8, ["return level of cycles"] = 10, ["spindle speed mode"] = 13, ["part rotation"] = 16,
  ["polar programming"] = 17, ["mirror image"] = 22,
}
local numbers = {
  [2] = 17, [3] = 90, [4] = 23, [5] = 94, [6] = core.unit_mm() == 1 and 21 or 20, [7] = 40, [8] = 49, [10] = 98, [11] = 14,
  [13] = 97, [16] = 69, [17] = 15, [22] = 50.1,
}

local last = {}   -- letter -> value of the last word F, S, T, D, H or M

for name, group in unordered(core.codes.group) do
  local index, is_m = variable_by_key[group], name:byte() == ("M"):byte()
  local number = (index or is_m) and code_number(name)
  if index then words.before(name, "modal codes", function() numbers[index] = number end) end
  if is_m then words.before(name, "modal codes", function() last.M = number end) end
end

-- Without words, both codes of scaling end it.
words.before({ "G14", "G14_1" }, "modal codes", function(_, given)
  numbers[11] = given ~= nil and next(given) ~= nil and 14.1 or 14
end)

words.before({ "F", "S", "T", "D", "H" }, "modal codes", function(name, value) last[name] = value or last[name] end)

-- Codes with a state that is stored elsewhere.
local externally_stored = {
  [1] = function()
    local number = core.motion() ~= "CIP" and code_number(core.motion())
    return number and number < 70 and number or 0
  end,
  [9] = function()
    local number = cycles.is_cycle(core.motion()) and code_number(core.motion())
    return number or 80
  end,
  [12] = function() return ab9_macros.modal_code() end,
  [14] = function() return tonumber(state.frame) end,
  [15] = function() return state.path_mode end,
}

local letters = { [7] = "D", [9] = "F", [11] = "H", [13] = "M", [19] = "S", [20] = "T" }

-- Returns the code of a group (#4001 to #4022) or the last word of a letter (#4107 .. #4120), vacant before
-- the first one. The second result is nil if the controller has no such group or letter.
local function modal_code(variable)
  local index = variable - 4000
  if externally_stored[index] then return externally_stored[index](), true end
  if numbers[index] ~= nil then return numbers[index], true end
  local letter = letters[index - 100]
  if letter then return last[letter], true end
  return nil, nil
end

return { modal_code = modal_code }
