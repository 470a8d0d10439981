-- RS274/NGC: G38.2 to G38.5, straight probing. The results are #5061 to #5069 (the point) and #5070 (found or not).

local FIRST_RESULT, FOUND = 5061, 5070

-- Where no script answers, the probe goes to its end, finds nothing, and LinuxCNC's dry run takes the program
-- to be this far before it; followed so that what comes next agrees with it.
local RECOIL_MM = 0.254

local function store_result(point, found)
  local program = core.to_program(point)
  for i, letter in ipairs(ngc.letters) do
    local value = program[letter]
    ngc.set_parameter(FIRST_RESULT + i - 1, value and ngc.to_program_unit(letter, value) or 0)
  end
  ngc.set_parameter(FOUND, found and 1 or 0)
end

-- Stands in the path until the next move, which begins at the recoiled point.
local recoil = {}

function recoil:leave() path.remove_filter(self) end
function recoil:rapid(target, place)
  self:leave()
  self.next:rapid(target, place)
end
function recoil:line(target, feed, kind, place)
  self:leave()
  self.next:line(target, feed, kind, place)
end
function recoil:arc(plane, ccw, first, second, sweep, target, feed, place)
  local start = ngc.programmed()
  self:leave()
  self.next:rapid(start, place)
  self.next:arc(plane, ccw, first, second, sweep, target, feed, place)
end
function recoil:act(f) self.next:act(f) end
function recoil:flush() end

local function go_back(from, to)
  local way = 0
  for _, letter in ipairs { "x", "y", "z" } do way = way + ((to[letter] or 0) - (from[letter] or 0)) ^ 2 end
  if way == 0 then return end
  local part = RECOIL_MM / math.sqrt(way)
  local point = {}
  for letter, value in pairs(to) do
    local is_space = letter == "x" or letter == "y" or letter == "z"
    point[letter] = is_space and value + part * (from[letter] - value) or value
  end
  path.add_filter(recoil)
  core.set_programmed(point)
end

local function check(name, words, must_find)
  check_table(words, name)
  ngc.not_in_compensation(name)
  if state.feed_mode ~= "minute" then alarm("%s needs a feed per minute (G94)", name) end
  if core.in_machine_frame() then alarm("G53 is for G0 and G1, not for %s", name) end
  local target, named = core.target(resolve_words(words or {}))
  if not named then alarm("%s needs the axis words of its end", name) end
  local from, moves = ngc.programmed(), false
  for letter, value in pairs(target) do moves = moves or value ~= from[letter] end
  if must_find and not moves then alarm("%s begins at its end; it needs a way to go", name) end
  return target, from
end

local function define(name, must_find, toward)
  local shown = name:sub(1, 3) .. "." .. name:sub(5)
  local function meaning(words)
    local target, from = check(shown, words, must_find)
    local point = move_until_signal(target)
    store_result(point or target, point ~= nil)
    path.event("probe", point and "found" or "nothing found")
    if point == nil and not probe_answers() then
      go_back(from, target)
    elseif point == nil and must_find then
      alarm("%s has come to its end, and the probe has not %s", shown, toward and "touched anything" or "come free")
    end
  end
  local modal = core.word(word_id(), meaning)
  word(name, function(words)
    make_modal(shown, modal)
    meaning(words)
  end)
end
define("G38_2", true, true)
define("G38_3", false, true)
define("G38_4", true, false)
define("G38_5", false, false)
