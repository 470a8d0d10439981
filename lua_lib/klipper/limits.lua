-- Limits of the following moves: M204, SET_VELOCITY_LIMIT.

local alarm = use("core/basics", "alarm")
local word = use("core/words", "word")

local function positive(value, name)
  if value ~= nil and value <= 0 then alarm("word-value", "%s must be greater than 0, not %.10g", name, value) end
  return value
end

-- S, or the smaller of P and T.
word("M204", function(words)
  words = words or {}
  local both = words.p and words.t and math.min(words.p, words.t)
  local acceleration = positive(words.s or both, "the acceleration of M204")
  if acceleration == nil then
    core.warn("M204 needs S, or both P and T; it has no effect with only one of P and T")
    return
  end
  core.set_path_limits { acceleration = acceleration }
end)

word("SET_VELOCITY_LIMIT", function(words)
  words = words or {}
  local corner, cruise = words.square_corner_velocity, words.minimum_cruise_ratio
  if corner and corner < 0 then alarm("word-value", "SQUARE_CORNER_VELOCITY must be 0 or greater, not %.10g", corner) end
  if cruise and (cruise < 0 or cruise >= 1) then
    alarm("word-value", "MINIMUM_CRUISE_RATIO must be at least 0 and less than 1, not %.10g", cruise)
  end
  core.set_path_limits {
    speed = positive(words.velocity, "VELOCITY"), acceleration = positive(words.accel, "ACCEL"),
    square_corner_velocity = corner, minimum_cruise_ratio = cruise,
  }
end)
