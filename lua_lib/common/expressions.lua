-- Functions of expressions that are the same in both dialects. A vacant variable is nil and counts as 0.

local alarm = use("core/basics", "alarm")

local function number_of(value)
  if value == nil then return 0 end
  if type(value) ~= "number" then alarm("script", "an expression has a value that is not a number") end
  return value
end

local function rounded(value)
  value = number_of(value)
  return value < 0 and math.ceil(value - 0.5) or math.floor(value + 0.5)
end

local function check_domain(name, value, ok)
  if not ok then alarm("arithmetic", "%s of %.10g has no value", name, value) end
end

function env.div(a, b)
  a, b = number_of(a), number_of(b)
  if b == 0 then alarm("arithmetic", "division by zero") end
  return a / b
end

-- Angles are in degrees.
function env.SIN(a) return core.sin_deg(number_of(a)) end
function env.COS(a) return core.cos_deg(number_of(a)) end
function env.TAN(a) return core.tan_deg(number_of(a)) end

function env.ASIN(a)
  a = number_of(a)
  check_domain("ASIN", a, a >= -1 and a <= 1)
  return core.asin_deg(a)
end

function env.ACOS(a)
  a = number_of(a)
  check_domain("ACOS", a, a >= -1 and a <= 1)
  return core.acos_deg(a)
end

function env.SQRT(a)
  a = number_of(a)
  check_domain("SQRT", a, a >= 0)
  return math.sqrt(a)
end

function env.LN(a)
  a = number_of(a)
  check_domain("LN", a, a > 0)
  return math.log(a)
end

function env.ABS(a) return math.abs(number_of(a)) end
function env.ROUND(a) return rounded(a) + 0.0 end
function env.goto_target(value)
  core.note_place()
  local whole = rounded(value)
  if math.abs(number_of(value) - whole) > 1e-6 then alarm("jump", "GOTO %.10g: a block number must be an integer", value) end
  return whole
end

-- It is at the end of the program; the reported source location is that of the GOTO.
function env.no_target(number)
  core.alarm_at_noted_place("jump", ("GOTO %.10g: this program has no block with that number "
    .. "(a computed GOTO cannot enter a loop from outside)"):format(number))
end

-- Block delete: /n is skipped if the operator has switched block delete on.
function env.skipped() return core.block_delete end

-- Text for the system variable that is set next: the remark of its block (#3000, #3006 of the 9/Series).
local remark
function env.message(text) remark = text end

local function release_comment()
  local text = remark
  remark = nil
  return text
end

return { number_of = number_of, rounded = rounded, release_comment = release_comment }
