-- Planes of the program in machine coordinates. A main plane is its name. An oblique one, which a rotation
-- makes of it, is a table { first = {x=, y=, z=}, second = {...} } of two unit vectors at right angles: the
-- form of core.arc.

local axes = use "core/axes"

-- Axes of each plane in the order in which its angles are counted, and the words of the centre.
local planes = {
  xy = { first = "x", second = "y", third = "z", i = "i", j = "j", k = "k" },
  zx = { first = "z", second = "x", third = "y", i = "k", j = "i", k = "j" },
  yz = { first = "y", second = "z", third = "x", i = "j", j = "k", k = "i" },
}

local LETTERS = { "x", "y", "z" }
local SAME = 1e-9   -- of unit vectors

local function cross(a, b)
  return { x = a.y * b.z - a.z * b.y, y = a.z * b.x - a.x * b.z, z = a.x * b.y - a.y * b.x }
end

-- Returns a plane of the program in machine coordinates, and true if counterclockwise is the same sense in
-- both.
local function machine_plane(name)
  if not core.has_matrix() then return name, true end
  local p = planes[name]
  local normal = cross(axes.direction(p.first), axes.direction(p.second))
  return core.plane_across(normal.x, normal.y, normal.z)
end

local function same_vector(a, b)
  return math.abs(a.x - b.x) + math.abs(a.y - b.y) + math.abs(a.z - b.z) < SAME
end

local function same_plane(a, b)
  if type(a) ~= "table" or type(b) ~= "table" then return a == b end
  return same_vector(a.first, b.first) and same_vector(a.second, b.second)
end

-- --- Points in the coordinates of a plane ---
--
--   view:at(point)        along its two directions; for a vector of X, Y and Z likewise
--   view:height(point)    along its normal
--   view:put(point, at)   moves a point of the machine within the plane to there
--   view.letters          the axes that define a position in the plane
--
-- Axes that the machine does not have count as 0.

local main = {}
main.__index = main

function main:at(point) return { point[self.first] or 0, point[self.second] or 0 } end
function main:height(point) return point[self.third] or 0 end
function main:put(point, at) point[self.first], point[self.second] = at[1], at[2] end

local oblique = {}
oblique.__index = oblique

local function along(direction, point)
  return direction.x * (point.x or 0) + direction.y * (point.y or 0) + direction.z * (point.z or 0)
end

function oblique:at(point) return { along(self.first, point), along(self.second, point) } end
function oblique:height(point) return along(self.normal, point) end

function oblique:put(point, at)
  local old = self:at(point)
  for _, letter in ipairs(LETTERS) do
    local way = self.first[letter] * (at[1] - old[1]) + self.second[letter] * (at[2] - old[2])
    if point[letter] then point[letter] = point[letter] + way end
  end
end

local function plane_view(plane)
  local p = planes[plane]
  if p then
    return setmetatable({ first = p.first, second = p.second, third = p.third, letters = { p.first, p.second } }, main)
  end
  local first, second = plane.first, plane.second
  return setmetatable({ first = first, second = second, normal = cross(first, second), letters = LETTERS }, oblique)
end

return { planes = planes, machine_plane = machine_plane, same_plane = same_plane, view = plane_view }
