-- Units, absolute or incremental dimensions, planes, and what the words of offsets share.

-- Calls set(letter, value in mm or deg) for each axis word; other keys that may stand there are in `others`, each
-- between blanks. False where no axis is named.
function each_axis(words, name, others, set)
  if type(words) ~= "table" then alarm("word-missing", "%s needs axis words", name) end
  local any = false
  for letter, value in pairs(words) do
    if type(value) ~= "number" then alarm("script", "%s: the value of '%s' is no number", name, tostring(letter)) end
    if is_rotary[letter] ~= nil then
      any = true
      set(letter, in_mm(letter, value))
    elseif others:find(" " .. tostring(letter) .. " ", 1, true) == nil then
      no_axis(letter, value, name)
    end
  end
  return any
end

function no_axis(letter, _, name) alarm("axis", "%s: the machine has no axis %s", name, tostring(letter):upper()) end

local function set_unit(millimetres)
  return function()
    state.unit_mm = millimetres
    core.set_unit(millimetres)
  end
end
word("G20", set_unit(25.4))
word("G21", set_unit(1))
core.set_unit(state.unit_mm)

local function set_incremental(on)
  return function()
    state.incremental = on
    core.set_incremental(on)
  end
end
word("G90", set_incremental(false))
word("G91", set_incremental(true))

function set_plane(plane)
  state.plane = plane
  core.set_plane(plane)
end
word("G17", function() set_plane("xy") end)
word("G18", function() set_plane("zx") end)
word("G19", function() set_plane("yz") end)

if core.dialect == "ab9" then include "ab9_frames" end   -- compensation watches its words
