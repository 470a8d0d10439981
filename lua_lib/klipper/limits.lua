-- Limits of the following moves: M204, SET_VELOCITY_LIMIT.

local alarm = use("core/basics", "alarm")
local word = use("core/words", "word")

local function positive(value, name)
  if value ~= nil and value <= 0 then alarm("word-value", "%s is above 0, not %.10g", name, value) end
  return value
end

-- S, or the smaller of P and T.
word("M204", function(words)
  words = words or {}
  local both = words.p and words.t and math.min(words.p, words.t)
  local acceleration = positive(words.s or both, "the acceleration of M204")
  if acceleration == nil then
    core.warn("M204 takes S, or P and T: with one of these it has no effect")
    return
  end
  core.set_path_limits { acceleration = acceleration }
end)

word("SET_VELOCITY_LIMIT", function(words)
  words = words or {}
  local corner, cruise = words.square_corner_velocity, words.minimum_cruise_ratio
  if corner and corner < 0 then alarm("word-value", "SQUARE_CORNER_VELOCITY is 0 or above, not %.10g", corner) end
  if cruise and (cruise < 0 or cruise >= 1) then
    alarm("word-value", "MINIMUM_CRUISE_RATIO is 0 or above and below 1, not %.10g", cruise)
  end
  core.set_path_limits {
    speed = positive(words.velocity, "VELOCITY"), acceleration = positive(words.accel, "ACCEL"),
    square_corner_velocity = corner, minimum_cruise_ratio = cruise,
  }
end)
