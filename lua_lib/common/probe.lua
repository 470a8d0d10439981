-- Moves that a signal ends: probing, skip. The signal comes from what stands in the cell, from what --probe tells, or a
-- script says where:
--   on_probe(function(from, to) return point or part or nil end)
-- `from` and `to` hold machine coordinates by axis letter (mm, deg); the answer is a point on the way, or the part of
-- the way from 0 to 1, or nil where nothing is touched. A function `probe` of the script does the same.

local alarm = use("core/basics", "alarm")
local path = use "core/path"

local OFF_THE_WAY_MM = 0.01   -- how far an answer may lie beside the way

local answer

function env.on_probe(f)
  if f ~= nil and type(f) ~= "function" then alarm("script", "on_probe takes a function") end
  answer = f
end

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
      alarm("probe", "the probe's answer: '%s' is no axis value", tostring(letter))
    end
    local way = to[letter] - from[letter]
    along, length = along + (value - from[letter]) * way, length + way * way
  end
  local part = length > 0 and along / length or 0
  for letter, value in pairs(point) do
    local aside = math.abs(value - (from[letter] + part * (to[letter] - from[letter])))
    if aside > OFF_THE_WAY_MM then
      alarm("probe", "the probe's answer lies %.6g beside the way on axis %s", aside, letter:upper())
    end
  end
  return part
end

-- What the script says of the way: the part of it where the signal comes, false where none does, nil without a script.
local function part_answered(from, to)
  local f = answer or rawget(env, "probe")
  if f == nil then return nil end
  local found = f(between(from, to, 0), between(from, to, 1))
  if found == nil or found == false then return false end
  local part = type(found) == "table" and part_of(from, to, found) or found
  if type(part) ~= "number" or part ~= part then alarm("probe", "the probe answers with a point, a part of the way, or nil") end
  if part < -1e-9 or part > 1 + 1e-9 then alarm("probe", "the probe's answer lies outside the way (%.6g of it)", part) end
  return math.max(0, math.min(1, part))
end

-- Moves toward `target` until the probe touches, or with `away` until it comes free. Gives whether it did, whether it
-- had before the move (which is none then; a script is taken to mean it), and where: machine coordinates by letter. The
-- machine stops as soon as it can behind that point.
return function(target, away)
  path.flush()
  local from = {}
  for letter in pairs(target) do from[letter] = core.machine_position(letter) end
  local part = part_answered(from, target)
  local found, at_start, point = path.probe(target, away, part)
  return found, at_start and part == nil, point
end
