-- RS274/NGC: G38.2 to G38.5, straight probing. The results are #5061 to #5069 (the point) and #5070 (found or not).

local FIRST_RESULT, FOUND = 5061, 5070

-- Where no script answers, the probe goes to its end, finds nothing, and LinuxCNC's dry run takes the program
-- to be this far before it; followed so that what comes next agrees with it.
local RECOIL_MM = 0.254

local function store_result(point, found)
  local program = core.to_program(point)
  for i, letter in ipairs(ngc.letters) do
    local value = program[letter]
    ngc.set_parameter(FIRST_RESULT + i - 1, value and in_program_units(letter, value) or 0)
  end
  ngc.set_parameter(FOUND, found and 1 or 0)
end

local function go_back(from, to)
  local way = space_between(from, to)
  if way == 0 then return end
  local point = copied(to)
  for _, letter in ipairs { "x", "y", "z" } do
    if to[letter] then point[letter] = to[letter] + RECOIL_MM / way * (from[letter] - to[letter]) end
  end
  path.go_on_from(point)
end

local function check(name, words, must_find)
  check_table(words, name)
  refuse_with_compensation(name)
  if state.feed_mode ~= "minute" then alarm("%s needs a feed per minute (G94)", name) end
  if core.in_machine_frame() then alarm("G53 is for G0 and G1, not for %s", name) end
  local target, named = core.target(resolve_words(words or {}))
  if not named then alarm("%s needs the axis words of its end", name) end
  local from, moves = programmed_point(), false
  for letter, value in pairs(target) do moves = moves or value ~= from[letter] end
  if must_find and not moves then alarm("%s begins at its end; it needs a way to go", name) end
  return target, from
end

local function define(name, must_find, toward)
  local shown = name:sub(1, 3) .. "." .. name:sub(5)
  modal_word(name, function(words)
    local target, from = check(shown, words, must_find)
    local point = move_until_signal(target)
    store_result(point or target, point ~= nil)
    path.event("probe", point and "found" or "nothing found")
    if point == nil and not probe_answers() then
      go_back(from, target)
    elseif point == nil and must_find then
      alarm("%s has come to its end, and the probe has not %s", shown, toward and "touched anything" or "come free")
    end
  end)
end
define("G38_2", true, true)
define("G38_3", false, true)
define("G38_4", true, false)
define("G38_5", false, false)
