-- Common messages and checks of all files of the library.

local integer_tolerance = use("core/dialect", "integer_tolerance")

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

-- Checks the words of a move, in a table by their letters; nil counts as no words.
function basics.check_table(words, name)
  if words ~= nil and type(words) ~= "table" then
    alarm("script", "%s needs its words in braces: %s{x=1, y=2}", name, name)
  end
end

-- Returns true if a word that is used alone has a value: nil is a vacant variable, and the word counts as
-- left out.
function basics.given(value, name)
  if value ~= nil and type(value) ~= "number" then alarm("script", "%s needs a number", name) end
  return value ~= nil
end

-- Returns the integer as which a number counts in the dialect, else the number.
function basics.snap_to_integer(value)
  if integer_tolerance == 0 or type(value) ~= "number" then return value end
  local near = math.floor(value + 0.5)
  return math.abs(value - near) <= integer_tolerance and near or value
end

-- Returns a word in printed form: G92_1 is G92.1.
function basics.printed(name)
  local at = name:find("_", 1, true)
  return at and name:sub(1, at - 1) .. "." .. name:sub(at + 1) or name
end

-- Returns the number of a word's code: 92.1 for G92_1.
function basics.code_number(name) return tonumber(basics.printed(name:sub(2))) end

-- Returns the distance of two points in space; axes that the machine does not have count as 0.
function basics.distance_in_space(a, b)
  local sum = 0
  for _, letter in ipairs { "x", "y", "z" } do sum = sum + ((b[letter] or 0) - (a[letter] or 0)) ^ 2 end
  return math.sqrt(sum)
end

return basics
