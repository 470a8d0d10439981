-- Programmable zone (G22, G23): a box in machine coordinates. The tool must not enter it if it is outside
-- when the zone is switched on, and must not leave it if it is inside. With P: zones of the machine data. The
-- core monitors them.

local alarm = use("core/basics", "alarm")
local word = use("core/words", "word")
local axes, path = use "core/axes", use "core/path"

local MIN_EXTENT_MM = 2e-6   -- nearer than half of it is on a wall

local LETTERS = { "x", "y", "z" }
local OTHER = { x = "i", y = "j", z = "k" }

local box   -- letter -> { low, high } in mm; an axis that is not named has no walls

local function wall(words, key)
  if type(words[key]) ~= "number" or words[key] ~= words[key] or math.abs(words[key]) == math.huge then
    alarm("script", "G22: the value of '%s' is not a number", key)
  end
  return words[key] * core.unit_mm()
end

local function read_box(words)
  local read = {}
  for key in pairs(words) do
    if not (" x y z i j k "):find(" " .. tostring(key) .. " ", 1, true) then
      alarm("word-out-of-place",
        "G22 does not accept the word %s here; it accepts X, Y, Z (one corner) and I, J, K (the other), or only P",
        tostring(key):upper())
    end
  end
  for _, letter in ipairs(LETTERS) do
    local other = OTHER[letter]
    if (words[letter] == nil) ~= (words[other] == nil) then
      alarm("word-missing", "G22 needs both %s and %s, the two limits of the zone on axis %s", letter:upper(),
        other:upper(),
        letter:upper())
    end
    if words[letter] ~= nil then
      if axes.is_rotary[letter] ~= false then
        alarm("axis", "G22: the machine has no linear axis %s", letter:upper())
      end
      local a, b = wall(words, letter), wall(words, other)
      if math.abs(a - b) <= MIN_EXTENT_MM then
        alarm("word-value", "G22: the zone has no extent on axis %s: %s and %s are both %.10g mm", letter:upper(),
          letter:upper(),
          other:upper(), a)
      end
      read[letter] = { math.min(a, b), math.max(a, b) }
    end
  end
  return read
end

local function has_only_number(words)
  return words ~= nil and words.p ~= nil and next(words, next(words)) == nil
end

local function put(zone)
  path.act(function() core.set_zone(zone) end)
end

-- G22 X Y Z I J K: two opposite corners, in any order; without words: the zone that was given last. G22 P:
-- zones of the machine data.
word("G22", function(words)
  if has_only_number(words) then return env.switch_zone(words.p, true) end
  if words ~= nil and next(words) ~= nil then box = read_box(words) end
  if box == nil then
    alarm("word-missing", "G22 needs its zone: X, Y, Z and I, J, K, two opposite corners in machine coordinates")
  end
  put(box)
end)

word("G23", function(words)
  if has_only_number(words) then return env.switch_zone(words.p, false) end
  if words ~= nil and next(words) ~= nil then
    alarm("word-value", "G23 accepts only P, the number of zones of the machine data")
  end
  put(nil)
end)
