-- RS274/NGC: G38.2 to G38.5, straight probing. The results are #5061 to #5069 (the point) and #5070 (found or not).

local dialect = use "core/dialect"
local alarm = use("core/basics", "alarm")
local axes, motion, move_until_signal, parameters, path, polar =
  use "core/axes", use "common/motion", use "common/probe", dialect.use "variables", use "core/path", use "common/polar"

local FIRST_RESULT, PROBE_FOUND = 5061, 5070

local function store_result(point, found)
  local program = core.to_program(point)
  for i, letter in ipairs(parameters.letters) do
    local value = program[letter]
    parameters.set(FIRST_RESULT + i - 1, value and axes.in_program_units(letter, value) or 0)
  end
  parameters.set(PROBE_FOUND, found and 1 or 0)
end

local function check(name, words, must_find)
  if core.feed_mode() ~= "minute" then alarm("mode", "%s needs a feed per minute (G94)", name) end
  if core.in_machine_frame() then alarm("probe", "G53 is for G0 and G1, not for %s", name) end
  local target, named = core.target(polar.resolve(words or {}))
  if not named then alarm("word-missing", "%s needs the axis words of its end", name) end
  local from, moves = axes.programmed_point(), false
  for letter, value in pairs(target) do moves = moves or value ~= from[letter] end
  if must_find and not moves then alarm("word-missing", "%s begins at its end; its distance must not be 0", name) end
  return target
end

local function define(name, must_find, away)
  local code_name = name:sub(1, 3) .. "." .. name:sub(5)
  motion.modal_word(name, function(words)
    local target = check(code_name, words, must_find)
    local found, at_start, point = move_until_signal(target, away)
    if at_start and must_find then
      alarm("probe", away and "%s moves away from a contact, but the probe has no contact at the start"
        or "%s moves to a contact, but the probe already has contact at the start", code_name)
    end
    store_result(point, found)
    path.event("probe", found and "found" or "nothing found")
    if not found and must_find then
      alarm("probe", "%s has reached its end, but the probe has not %s", code_name, away and "lost contact" or "made contact")
    end
  end)
end
define("G38_2", true, false)
define("G38_3", false, false)
define("G38_4", true, true)
define("G38_5", false, true)
