-- RS274/NGC: a target in polar form, @5 ^30 as G1{radius=5, angle=30}. Absolute: distance and angle in the XY
-- plane from the zero point of the program; incremental: both are added to those of the current point. A
-- missing value does not change.

local alarm, copied = use("core/basics", "alarm", "copied")
local axes = use "core/axes"

local POLE_TOLERANCE = 1e-9

core.on_polar(function(words)
  if words.x ~= nil or words.y ~= nil then
    alarm("word-value", "a target is given by @ and ^ or by X and Y, not by both")
  end
  local program = axes.program_position()
  local x, y = program.x / core.unit_mm(), program.y / core.unit_mm()
  local radius, angle = math.sqrt(x * x + y * y), math.atan(y, x)
  if radius < POLE_TOLERANCE and (core.is_incremental() or words.angle == nil) then
    alarm("word-value",
      "@ without ^, ^ without @ and their increments need a current point that is not the zero point")
  end
  if core.is_incremental() then
    radius, angle = radius + (words.radius or 0), angle + math.rad(words.angle or 0)
  else
    radius, angle = words.radius or radius, words.angle and math.rad(words.angle) or angle
  end
  local cartesian = copied(words)
  cartesian.radius, cartesian.angle = nil, nil
  local to_x, to_y = radius * math.cos(angle), radius * math.sin(angle)
  if core.is_incremental() then to_x, to_y = to_x - x, to_y - y end
  cartesian.x, cartesian.y = to_x / core.word_factor("x"), to_y / core.word_factor("y")
  return cartesian
end)
