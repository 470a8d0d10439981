-- Polar programming: the first axis word of the plane is a radius, the second an angle in degrees, about the zero
-- point of the work coordinate system. Incremental: the angle adds to the last one, and the radius is the length
-- of a step in that direction.

local copied = use("core/basics", "copied")
local word = use("core/words", "word")
local plane_view, shape, state = use "core/plane_view", use "core/motion_modifiers", use "core/state"

local polar = {}

local angle = { xy = 0, zx = 0, yz = 0 }
local radius = { xy = 0, zx = 0, yz = 0 }

local by_another   -- returns the words of a move instead of polar programming, or nil

-- Sets f(words) to return the words of moves from here on (lines by their angle); nil: not any more.
function polar.resolve_by(f) by_another = f end

-- Returns the words of a move with Cartesian values instead of polar ones; the table itself if polar
-- programming is off.
function polar.resolve(words)
  if by_another then return by_another(words) end
  if not state.polar or core.in_machine_frame() then return words end   -- machine coordinates are no radius and angle
  local p = plane_view.planes[core.plane()]
  if words[p.first] == nil and words[p.second] == nil then return words end
  local turn, reach = words[p.second], words[p.first]
  if core.is_incremental() then
    angle[core.plane()] = angle[core.plane()] + (turn or 0)
    reach = reach or 0
  else
    angle[core.plane()] = turn or angle[core.plane()]
    reach = reach or radius[core.plane()]
    radius[core.plane()] = reach
  end
  local resolved = copied(words)
  resolved[p.first] = reach * math.cos(math.rad(angle[core.plane()]))
  resolved[p.second] = reach * math.sin(math.rad(angle[core.plane()]))
  return resolved
end

word("G16", function()
  state.polar = true
  shape("polar programming", true)
end)

word("G15", function()
  state.polar = false
  for plane in pairs(plane_view.planes) do angle[plane], radius[plane] = 0, 0 end
  shape("polar programming", false)
end)

return polar
