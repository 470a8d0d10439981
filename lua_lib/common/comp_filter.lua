-- Common part of the two kinds of cutter compensation: a filter of the path (see core/path.lua) that knows
-- the positions of the program and of the machine. It receives moves as items, and outputs moves with shifted
-- ends.
--
-- An item is one call of the path: { kind = "rapid", "line", "arc" or "act", source, target, feed, place,
-- segment, f }. `source` and `target`, its programmed ends, name every axis; `segment`
-- (common/comp_geometry.lua) is nil without motion in the plane. An action stores its own source location.

local alarm, copied, distance_in_space = use("core/basics", "alarm", "copied", "distance_in_space")
local axes, g, plane_view = use "core/axes", use "common/comp_geometry", use "core/plane_view"

local SAME_POINT_MM = 1e-9
local MIN_RADIUS_MM = 1e-6
local MIN_FEED = 0.1   -- program units in a minute

local comp_filter = {}
comp_filter.__index = comp_filter

-- Makes a filter class; fields: side, radius (mm), plane.
function comp_filter.derive()
  local class = setmetatable({}, comp_filter)
  class.__index = class
  return class
end

function comp_filter.make(class, fields)
  local filter = setmetatable(fields, class)
  filter.machine_plane_of_path, filter.same_sense = plane_view.machine_plane(filter.plane)
  filter.view = plane_view.view(filter.machine_plane_of_path)
  filter.programmed = axes.programmed_point()
  filter.at = filter.view:at(axes.machine_point())
  return filter
end

function comp_filter:point(target) return self.view:at(target) end

function comp_filter:complete(target)
  local all = copied(self.programmed)
  for letter, value in unordered(target) do all[letter] = value end
  return all
end

-- Inverse time is a speed on the programmed path, and the tool keeps that speed on its own path.
local function feed_at_programmed_speed(feed, length_mm)
  if not feed.motion_s or length_mm == 0 then return feed end
  return core.feed_mm_min(math.max(length_mm / feed.motion_s * 60, MIN_FEED * core.unit_mm()))
end

-- Returns a straight move as an item. Only moves in the plane get a segment.
function comp_filter:straight(kind, target, feed, linear_kind, place)
  if linear_kind and linear_kind ~= "linear" then
    alarm("compensation", "a %s move is not possible while cutter compensation is on; program G40 first", linear_kind)
  end
  local item = { kind = kind, source = self.programmed, target = self:complete(target), place = place or core.place() }
  if kind == "line" then
    item.feed = feed_at_programmed_speed(feed or core.take_feed(), distance_in_space(self.programmed, item.target))
  end
  local from, to = self:point(self.programmed), self:point(item.target)
  if g.distance(from, to) > SAME_POINT_MM then item.segment = g.line(from, to) end
  self.programmed = item.target
  return item
end

function comp_filter:circular(plane, ccw, first, second, sweep_rad, target, feed, place)
  if not plane_view.same_plane(plane, self.machine_plane_of_path) then
    alarm("compensation", "an arc in plane %s is not possible while cutter compensation is on in plane %s; program G40 first",
      core.plane():upper(), self.plane:upper())
  end
  local item = { kind = "arc", source = self.programmed, target = self:complete(target), place = place or core.place() }
  local from, to, centre = self:point(self.programmed), self:point(item.target), { first, second }
  if g.distance(from, centre) < MIN_RADIUS_MM or g.distance(to, centre) < MIN_RADIUS_MM then
    alarm("compensation", "an arc that starts or ends at its centre has no side for cutter compensation")
  end
  item.segment = g.arc(from, to, centre, ccw, sweep_rad)
  local rise = self.view:height(item.target) - self.view:height(self.programmed)
  local length = math.sqrt((g.distance(from, centre) * sweep_rad) ^ 2 + rise * rise)
  item.feed = feed_at_programmed_speed(feed or core.take_feed(sweep_rad), length)
  self.programmed = item.target
  return item
end

-- Receive moves: take(item) of the class buffers each until the next ones are known.
function comp_filter:rapid(target, place) self:take(self:straight("rapid", target, nil, nil, place)) end
function comp_filter:line(target, feed, kind, place) self:take(self:straight("line", target, feed, kind, place)) end
function comp_filter:arc(...) self:take(self:circular(...)) end

-- Distance of the tool's own zero point from the middle of its edge radius: zero, except on a lathe.
comp_filter.origin = { 0, 0 }

function comp_filter:placed(target, point)
  local moved = copied(target)
  self.view:put(moved, { point[1] + self.origin[1], point[2] + self.origin[2] })
  self.at = point
  return moved
end

-- Outputs a straight move of the tool to a point; the other axes move to the target of the item.
function comp_filter:output_straight(item, point, target, feed)
  local moved = self:placed(target or item.target, point)
  if item.kind == "rapid" then
    self.next:rapid(moved, item.place)
  else
    self.next:line(moved, feed or item.feed, nil, item.place)
  end
end

function comp_filter:output_arc(item, point, centre, turn, sweep_rad, target, feed)
  local moved = self:placed(target or item.target, point)
  self.next:arc(self.machine_plane_of_path, turn > 0, centre[1] + self.origin[1], centre[2] + self.origin[2], sweep_rad, moved,
    feed or item.feed, item.place)
end

-- Outputs a move without a part in the plane, or an action, at the present position of the tool.
function comp_filter:output_other(item)
  if item.kind == "act" then
    self.next:act(item.f)
  else
    self:output_straight(item, self.at)
  end
end

local function rounded(value) return math.floor(value * 1e6 + 0.5) / 1e6 end

-- Raises an alarm for a move that runs backwards, or cannot be reached. The move that causes it is in the
-- line being executed or in one shortly before it.
function comp_filter:raise_alarm(item, text, ...)
  local to = item.segment and item.segment.to or self:point(item.target)
  local point = copied(item.target)
  self.view:put(point, to)
  local named = {}
  for _, letter in ipairs(self.view.letters) do
    if point[letter] then named[#named + 1] = ("%s%.10g"):format(letter:upper(), rounded(point[letter])) end
  end
  local where = ("the move to %s mm"):format(table.concat(named, " "))
  alarm("compensation", "cutter compensation with radius %.10g mm: " .. text, item.radius or self.radius, where, ...)
end

function comp_filter:check_fits(item, side, radius)
  local segment = item.segment
  if segment.centre and g.tool_inside(segment, side) and segment.radius <= radius then
    self:raise_alarm(item, "%s is an arc of radius %.10g mm with the tool inside; the arc must be larger than the tool",
      segment.radius)
  end
end

return comp_filter
