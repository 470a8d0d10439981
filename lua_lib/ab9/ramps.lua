-- Ramps of motion. At the start of a run the machine's controller selects them.

local alarm = use("core/basics", "alarm")
local word = use("core/words", "word")
local frames, path = use "common/frames", use "core/path"

local function mode(name, ramps)
  word(name, function() path.act(function() core.set_ramps(ramps) end) end)
end
mode("G47", "linear")
mode("G47_1", "s_curve")
mode("G47_9", "infinite")

-- Sets limits of the axes named, in program units per s^2, and per s^3 for the jerk. They only lower those of
-- the machine.
local function limits(name, code, limit, unit)
  word(name, function(words)
    local values = {}
    local function set(letter, value)
      if not (value > 0) then
        alarm("word-value", "%s: %s must be greater than 0 (%s), not %.10g", code, letter:upper(), unit, words[letter])
      end
      values[letter] = value
    end
    if not frames.each_axis(words, code, "", set) then
      alarm("word-missing", "%s requires the axes whose ramps it sets", code)
    end
    path.act(function() core.set_ramp_limits(limit, values) end)
  end)
end
limits("G48_1", "G48.1", "acceleration", "per s^2")
limits("G48_2", "G48.2", "deceleration", "per s^2")
limits("G48_3", "G48.3", "jerk", "per s^3")

word("G48", function() path.act(core.reset_ramp_limits) end)
