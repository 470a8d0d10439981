-- FIXED and REFERENCE points of the machine data, for scripts: fixed "CLAMP1", fixed(3), reference(2).

local alarm = use("core/basics", "alarm")
local axes = use "core/axes"

local MAX_NAMED = 10

-- Returns a point as axis words in program units, so that G53() G0(fixed "CLAMP1") moves there in mm, in
-- inches and if X is a diameter. Axes that the machine does not have, or without a value in the point, are
-- left out. Each call returns a table of its own, in which a script may change or remove words.
local function point_words(point)
  local words = {}
  for _, axis in ipairs(axes.list) do
    local letter, value = axis.letter, point[axis.letter]
    words[letter] = value and axes.in_program_units(letter, value) / core.word_factor(letter)
  end
  return words
end

local function known(points)
  local numbers, texts = {}, {}
  for number in pairs(points) do numbers[#numbers + 1] = number end
  table.sort(numbers)
  for i = 1, math.min(#numbers, MAX_NAMED) do
    local name = points[numbers[i]].name
    texts[i] = name and ("%d (%s)"):format(numbers[i], name) or ("%d"):format(numbers[i])
  end
  local more = #numbers > MAX_NAMED and (" and %d more"):format(#numbers - MAX_NAMED) or ""
  return #numbers == 0 and "none are defined" or "available: " .. table.concat(texts, ", ") .. more
end

-- Defines env[name](which), which returns a point of that table by its number, or by its name in any case.
-- `what` is the name of a point in messages, `section` that of its table in the machine data.
local function define(name, points, what, section)
  local by_name = {}
  for _, point in pairs(points) do
    if point.name then by_name[point.name:upper()] = point end
  end
  env[name] = function(which)
    local is_name = type(which) == "string"
    if not is_name and type(which) ~= "number" then
      alarm("script", "%s needs the name or the number of a %s: %s \"CLAMP1\", %s(1)", name, what, name, name)
    end
    local point
    if is_name then point = by_name[which:upper()] else point = points[which] end
    if point then return point_words(point) end
    local call = is_name and ("%s %q"):format(name, which) or ("%s(%.14g)"):format(name, which)
    alarm("word-value", "%s: no %s has that %s; %s. A line of section %s of the machine data defines one: number X Y Z%s",
      call, what, is_name and "name" or "number", known(points), section, is_name and " NAME=" .. which or "")
  end
end

define("fixed", core.fixed, "fixed point", "FIXED")
define("reference", core.references, "reference point", "REFERENCE")
