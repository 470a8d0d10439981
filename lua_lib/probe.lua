-- Moves that a signal ends: probing, skip. A script says where the signal comes:
--   on_probe(function(from, to) return point or part or nil end)
-- `from` and `to` hold machine coordinates by axis letter (mm, deg); the answer is a point on the way, or the part of
-- the way from 0 to 1, or nil where nothing is touched. A function `probe` of the script does the same.

local OFF_THE_WAY_MM = 0.01   -- how far an answer may lie beside the way

local answer

function env.on_probe(f)
  if f ~= nil and type(f) ~= "function" then alarm("on_probe takes a function") end
  answer = f
end

function probe_answers() return answer ~= nil or rawget(env, "probe") ~= nil end

local function between(from, to, part)
  local point = {}
  for letter, value in pairs(from) do point[letter] = value + part * (to[letter] - value) end
  return point
end

-- The part of the way at which `point` lies; axes that it leaves out are on the way.
local function part_of(from, to, point)
  local along, length = 0, 0
  for letter, value in pairs(point) do
    if from[letter] == nil or type(value) ~= "number" then
      alarm("the probe's answer: '%s' is no axis value", tostring(letter))
    end
    local way = to[letter] - from[letter]
    along, length = along + (value - from[letter]) * way, length + way * way
  end
  local part = length > 0 and along / length or 0
  for letter, value in pairs(point) do
    local aside = math.abs(value - (from[letter] + part * (to[letter] - from[letter])))
    if aside > OFF_THE_WAY_MM then
      alarm("the probe's answer lies %.6g beside the way on axis %s", aside, letter:upper())
    end
  end
  return part
end

local function touched_at(from, to)
  local f = answer or rawget(env, "probe")
  if f == nil then return nil end
  local found = f(between(from, to, 0), between(from, to, 1))
  if found == nil or found == false then return nil end
  local part = type(found) == "table" and part_of(from, to, found) or found
  if type(part) ~= "number" or part ~= part then alarm("the probe answers with a point, a part of the way, or nil") end
  if part < -1e-9 or part > 1 + 1e-9 then alarm("the probe's answer lies outside the way (%.6g of it)", part) end
  return between(from, to, math.max(0, math.min(1, part)))
end

-- Moves toward `target` until the probe answers: the point where it does, or nil at the end of the way.
function move_until_signal(target)
  path.flush()
  local from = {}
  for letter in pairs(target) do from[letter] = core.machine_position(letter) end
  local point = touched_at(from, target)
  path.line(point or target, nil, "probe")
  return point
end
