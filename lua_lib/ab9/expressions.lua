-- Functions of expressions of the 9/Series.

local alarm = use("core/basics", "alarm")
local number_of, rounded = use("common/expressions", "number_of", "rounded")

-- AND, OR and XOR work on integers.
local function bits(value)
  local whole = rounded(value)
  return math.tointeger(whole) or alarm("arithmetic", "%.10g is too large for AND, OR and XOR", whole)
end

function env.MOD(a, b)
  a, b = number_of(a), number_of(b)
  if b == 0 then alarm("arithmetic", "MOD by zero") end
  return a - b * math.floor(a / b)
end

function env.AND(a, b) return (bits(a) & bits(b)) + 0.0 end
function env.OR(a, b) return (bits(a) | bits(b)) + 0.0 end
function env.XOR(a, b) return (bits(a) ~ bits(b)) + 0.0 end

-- One side: -90 to 90; two sides (ATAN[a]/[b]): the angle of the point (b, a), 0 to 360.
function env.ATAN(a, b)
  if b == nil then return core.atan_deg(number_of(a)) end
  local angle = core.atan_deg(number_of(a), number_of(b))
  return angle < 0 and angle + 360 or angle
end

function env.EXP(a) return math.exp(number_of(a)) end
function env.FIX(a) a = number_of(a) return (a < 0 and math.ceil(a) or math.floor(a)) + 0.0 end
function env.FUP(a) a = number_of(a) return (a < 0 and math.floor(a) or math.ceil(a)) + 0.0 end


-- BIN reads each group of four bits as a decimal digit, BCD is its inverse.
local function digits(value, from, to)
  local rest, result, weight = bits(value), 0, 1
  if rest < 0 then alarm("arithmetic", "BIN and BCD require numbers of 0 or greater") end
  while rest > 0 do
    result = result + (rest % from) * weight
    rest, weight = rest // from, weight * to
  end
  return result + 0.0
end
function env.BIN(a) return digits(a, 16, 10) end
function env.BCD(a) return digits(a, 10, 16) end

-- Convert a number to a condition, and a condition to a number.
function env.truth(value) return number_of(value) ~= 0 end
function env.number(condition) return condition and 1.0 or 0.0 end
