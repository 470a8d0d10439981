-- Units, absolute or incremental dimensions, planes, and the common part of the words of offsets.

local alarm = use("core/basics", "alarm")
local word = use("core/words", "word")
local axes, compensation = use "core/axes", use "common/compensation"

local ignores_missing_axes, refuses_plane_change = use("core/dialect", "ignores_missing_axes", "refuses_plane_change")

local AXES = { a = true, b = true, c = true, u = true, v = true, w = true, x = true, y = true, z = true }

-- Handles words that are no axis of the machine.
local function reject_axis_word(letter, value, name)
  local is_axis = not ignores_missing_axes or AXES[letter]
  if ignores_missing_axes and is_axis and value == 0 then return end
  if is_axis then alarm("axis", "%s: the machine has no axis %s", name, tostring(letter):upper()) end
  alarm("word-out-of-place", "%s does not accept the word '%s'", name, tostring(letter))
end

-- Calls set(letter, value in mm or deg) for each axis word; `others` has other permitted keys, each between
-- blanks. Returns false if no axis is named.
local function each_axis(words, name, others, set)
  if type(words) ~= "table" then alarm("word-missing", "%s needs axis words", name) end
  local any = false
  for letter, value in pairs(words) do
    if type(value) ~= "number" then alarm("script", "%s: the value of '%s' is not a number", name, tostring(letter)) end
    if axes.is_rotary[letter] ~= nil then
      any = true
      set(letter, axes.in_mm(letter, axes.word_in_units(letter, value)))
    elseif others:find(" " .. tostring(letter) .. " ", 1, true) == nil then
      reject_axis_word(letter, value, name)
    end
  end
  return any
end

word("G20", function() core.set_unit(25.4) end)
word("G21", function() core.set_unit(1) end)
word("G90", function() core.set_incremental(false) end)
word("G91", function() core.set_incremental(true) end)

for name, plane in pairs { G17 = "xy", G18 = "zx", G19 = "yz" } do
  word(name, function()
    if refuses_plane_change and plane ~= core.plane() then compensation.refuse(name .. ", a change of plane,") end
    core.set_plane(plane)
  end)
end

return { each_axis = each_axis }
