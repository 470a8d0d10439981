-- What all files of the library say and look at in the same way.

local basics = {}

-- Ends the run. `kind` is the code of a kind of diagnostic (base/text/diagnostic_kind.cpp); the text and its values are as
-- for string.format.
local function alarm(kind, text, ...)
  core.alarm(kind, text:format(...))
end
basics.alarm = alarm

function basics.copied(values)
  local copy = {}
  for key, value in unordered(values) do copy[key] = value end
  return copy
end

-- The words of a move, in a table by their letters; nil counts as none.
function basics.check_table(words, name)
  if words ~= nil and type(words) ~= "table" then
    alarm("script", "%s takes its words in braces: %s{x=1, y=2}", name, name)
  end
end

-- The value of a word that stands alone: nil is a vacant variable, and the word counts as left out.
function basics.given(value, name)
  if value ~= nil and type(value) ~= "number" then alarm("script", "%s takes a number", name) end
  return value ~= nil
end

-- RS274/NGC: a number within 0.0001 of a whole one counts as it, as in LinuxCNC; elsewhere it must be exact.
function basics.nearly_whole(value)
  if core.dialect ~= "rs274ngc" or type(value) ~= "number" then return value end
  local near = math.floor(value + 0.5)
  return math.abs(value - near) <= 1e-4 and near or value
end

-- A word as it is printed: G92_1 is G92.1.
function basics.printed(name)
  local at = name:find("_", 1, true)
  return at and name:sub(1, at - 1) .. "." .. name:sub(at + 1) or name
end

-- The number of a word's code: 92.1 of G92_1.
function basics.code_number(name) return tonumber(basics.printed(name:sub(2))) end

-- Distance of two points in space; axes that the machine does not have count as 0.
function basics.space_between(a, b)
  local sum = 0
  for _, letter in ipairs { "x", "y", "z" } do sum = sum + ((b[letter] or 0) - (a[letter] or 0)) ^ 2 end
  return math.sqrt(sum)
end

return basics
