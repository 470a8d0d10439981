-- Moves that a signal ends: probing, skip. The signal comes from the bodies in the cell, from --probe, or
-- from a script:
--   on_probe(function(from, to) return point or part or nil end)
-- `from` and `to` hold machine coordinates by axis letter (mm, deg). The result is a point on the path, or
-- the share of the path from 0 to 1, or nil without contact. A function `probe` of the script does the same.

local alarm = use("core/basics", "alarm")
local axes = use "core/axes"
local path = use "core/path"

local PATH_TOLERANCE_MM = 0.01   -- max distance of a result from the path

local handler

function env.on_probe(f)
  if f ~= nil and type(f) ~= "function" then alarm("script", "on_probe needs a function") end
  handler = f
end

local function between(from, to, part)
  local point = {}
  for letter, value in pairs(from) do point[letter] = value + part * (to[letter] - value) end
  return point
end

-- Returns the share of the path at which `point` lies; axes that it leaves out are on the path.
local function path_share(from, to, point)
  local along, length = 0, 0
  for letter, value in pairs(point) do
    if from[letter] == nil or type(value) ~= "number" then
      alarm("probe", "the result of the probe: '%s' is not an axis value", tostring(letter))
    end
    local travel = to[letter] - from[letter]
    along, length = along + (value - from[letter]) * travel, length + travel * travel
  end
  local part = length > 0 and along / length or 0
  for letter, value in pairs(point) do
    local lateral = math.abs(value - (from[letter] + part * (to[letter] - from[letter])))
    if lateral > PATH_TOLERANCE_MM then
      alarm("probe", "the result of the probe is %.6g %s off the path on axis %s", lateral,
            axes.is_rotary[letter] and "deg" or "mm", letter:upper())
    end
  end
  return part
end

-- Returns the script's result for the path: the share of it at the signal, false without a signal, nil
-- without a script.
local function scripted_share(from, to)
  local f = handler or rawget(env, "probe")
  if f == nil then return nil end
  local found = f(between(from, to, 0), between(from, to, 1))
  if found == nil or found == false then return false end
  local part = type(found) == "table" and path_share(from, to, found) or found
  if type(part) ~= "number" or part ~= part then alarm("probe", "the result of the probe must be a point, a fraction of the path, or nil") end
  if part < -1e-9 or part > 1 + 1e-9 then alarm("probe", "the result of the probe is outside the path (%.6g of it)", part) end
  return math.max(0, math.min(1, part))
end

-- Moves toward `target` until the probe touches, or with `away` until it comes free. Returns true if it did.
-- Also returns true if it had before the move, which is then not made (a script is assumed to mean it). The
-- third result is the position: machine coordinates by letter. The machine stops as soon as it can after that
-- point.
return function(target, away)
  path.flush()
  local from = {}
  for letter in pairs(target) do from[letter] = core.machine_position(letter) end
  local part = scripted_share(from, target)
  local found, at_start, point = path.probe(target, away, part)
  return found, at_start and part == nil, point
end
