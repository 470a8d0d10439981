-- Cutter compensation as in LinuxCNC (G40 to G42.1 of rs274ngc). A straight or circular entry move ends
-- offset from its programmed end. The path rounds outside corners with an arc about the corner. At inside
-- corners it shortens the move before. For that, one move in the plane and what follows it wait in a queue
-- until the next move is known.

local alarm = use("core/basics", "alarm")
local axes, comp_filter, g, plane_view = use "core/axes", use "common/comp_filter", use "common/comp_geometry", use "core/plane_view"

local SMALL_CORNER_RAD = 0.05     -- up to here it is not treated as a corner
local MAX_SPIRAL_MM = 0.04       -- between the radii of an arc's ends
local RADII_TOLERANCE = 0.01      -- of an arc that was cut back, in program units
-- An arc that becomes longer than programmed by more than that has been shortened past its other end.
local MAX_ARC_EXCESS_RAD = { metric = 0.0254, inch = 0.001 }

local TURN = 2 * math.pi

local ngc = comp_filter.derive()

-- The zero point of a lathe tool by its orientation: shares of the radius on the plane's two axes.
local orientation_shift = {
  { 1, -1 }, { -1, -1 }, { -1, 1 }, { 1, 1 }, { 1, 0 }, { 0, -1 }, { -1, 0 }, { 0, 1 },
}

local function make(side, radius, orientation)
  local filter = comp_filter.make(ngc, {
    side = side, radius = radius, plane = core.plane(),
    queue = {},              -- the move in the plane that waits, and what came after it
    last = nil,              -- the last move in the plane
    start = nil,             -- start of the waiting move, if it has to be monitored
  })
  local shift = orientation_shift[orientation]
  if shift then
    local p = plane_view.planes[filter.plane]
    local first, second = filter.view:at(axes.direction(p.first)), filter.view:at(axes.direction(p.second))
    filter.origin = {
      (shift[1] * first[1] + shift[2] * second[1]) * radius, (shift[1] * first[2] + shift[2] * second[2]) * radius,
    }
  end
  filter.tool = filter:point(filter.programmed)   -- position of the tool centre after everything known so far
  return filter
end

-- --- The queue ---

local UNREACHABLE_CORNER = "%s ends in an inside corner that the tool cannot reach without gouging"

local function is_off_circle(item, point)
  local other = g.distance(item.point, item.centre)
  return math.abs(g.distance(point, item.centre) - other) > RADII_TOLERANCE * core.unit_mm()
end

function ngc:cut_back(item, point)
  local segment = item.segment
  if not segment then return end
  if segment.centre then
    if is_off_circle(item, point) then self:raise_alarm(item, UNREACHABLE_CORNER) end
    if self.start then
      local sweep = g.swept_after(self.start, point, item.centre, segment.turn, segment.sweep)
      local tolerance = core.unit_mm() == 1 and MAX_ARC_EXCESS_RAD.metric or MAX_ARC_EXCESS_RAD.inch
      if sweep > segment.sweep + tolerance then self:raise_alarm(item, UNREACHABLE_CORNER) end
    end
  elseif self.start and item.watched and g.dot(segment.heading[1], g.minus(point, self.start)) < 0 then
    self:raise_alarm(item, UNREACHABLE_CORNER)
  end
end

function ngc:put(item)
  local segment = item.segment
  if item.kind == "act" then
    self.next:act(item.f)
  elseif not segment then
    self:output_straight(item, item.point or self.at)
  elseif segment.centre then
    -- After a corner below the limit, or a stop in an inside corner, the tool may be off the arc.
    if math.abs(g.distance(self.at, item.centre) - g.distance(item.point, item.centre)) > MAX_SPIRAL_MM then
      self:output_straight(item, g.offset_start(segment, self.side, self.radius), item.source)
    end
    local sweep = g.swept_after(self.at, item.point, item.centre, segment.turn, segment.sweep)
    self:output_arc(item, item.point, item.centre, segment.turn, sweep)
  else
    self:output_straight(item, item.point)
  end
end

function ngc:empty_queue()
  for _, item in ipairs(self.queue) do self:put(item) end
  self.queue = {}
  self.start = nil
end

-- Ends the waiting move at that point and outputs the queue.
function ngc:end_at(point)
  if #self.queue == 0 then return end
  for _, item in ipairs(self.queue) do
    self:cut_back(item, point)
    item.point = point
  end
  self:empty_queue()
  self.start = point
end

-- --- The first move ---

function ngc:enter_straight(item)
  local entry_length = g.distance(self.tool, item.segment and item.segment.to or self.tool)
  if entry_length <= self.radius then
    self:raise_alarm(item, "%s is the entry move; its length of %.10g mm in the plane must be greater than the radius", entry_length)
  end
  item.point = g.offset_end(item.segment, self.side, self.radius)
  self.start = self.tool
end

-- The entry arc runs from the tool's position to the offset programmed end. Its tangent there does not
-- change, so the centre is at the same distance from both, on the line through the programmed centre.
function ngc:enter_circular(item)
  local segment = item.segment
  if g.distance(self.at, self.tool) > MAX_SPIRAL_MM then
    alarm("compensation",
      "the first move after G40 leaves cutter compensation and must be straight (G0 or G1), not an arc")
  end
  local entry_length = g.distance(self.tool, segment.to)
  if entry_length <= self.radius then
    self:raise_alarm(item, "%s is the entry arc; its end is only %.10g mm from its start, not more than the radius", entry_length)
  end
  self:check_fits(item, self.side, self.radius)
  item.point = g.offset_end(segment, self.side, self.radius)
  local axis = g.unit(g.minus(segment.centre, item.point))
  local chord = g.minus(self.tool, item.point)
  local along = g.dot(axis, chord)
  if math.abs(along) < 0.0001 * g.length(chord) then
    self:raise_alarm(item, "%s is the entry arc; the tool does not fit into it")
  end
  item.centre = g.plus(item.point, axis, g.dot(chord, chord) / (2 * along))
  item.segment = g.arc(self.tool, segment.to, item.centre, segment.turn > 0, segment.sweep)
  item.segment.heading[2] = segment.heading[2]
  item.segment.radius = g.distance(item.centre, item.point) + segment.turn * self.side * self.radius
  local turns = math.ceil(segment.sweep / TURN - 1e-9) - 1
  item.segment.sweep = g.sweep_angle(self.tool, item.point, item.centre, segment.turn) + turns * TURN
  -- The zero point of a lathe tool first moves to the offset position, otherwise the arc is invalid.
  if self.origin ~= comp_filter.origin then
    self:output_straight({ kind = "line", feed = item.feed, place = item.place }, self.tool, item.source)
  end
end

-- --- Corners ---

-- Returns the angle by which the path turns away from the side of the tool: -90 to 270 degrees.
local function outward(from, to, side)
  local angle = -side * g.angle(from, to)
  return angle < -math.pi / 2 and angle + 2 * math.pi or angle
end

-- At a corner of half a turn the tool may move around its tip. It stays out if an arc leads in or out and the
-- tool runs on the outside of that arc.
local function is_inside(beta, before, after, side)
  if beta < -SMALL_CORNER_RAD or beta > math.pi + SMALL_CORNER_RAD then return true end
  if beta <= math.pi - SMALL_CORNER_RAD then return false end
  if after.centre then return not g.tool_inside(after, side) end
  return before ~= nil and before.centre ~= nil and not g.tool_inside(before, side)
end

-- Returns the move before, as LinuxCNC sees it. If only a move outside the plane waits after a stop, an arc
-- counts as the line in which it ended.
function ngc:segment_before()
  local segment, waiting = self.last.segment, self.queue[1]
  if waiting == nil or waiting.segment then return segment end
  return g.line(g.plus(segment.to, segment.heading[2], -self.radius), segment.to)
end

function ngc:inside_corner(item)
  local point = g.intersect(self:segment_before(), item.segment, self.side, self.radius)
  if not point then
    self:raise_alarm(item, "before %s is an inside corner that the tool does not fit into without gouging")
  end
  self:end_at(point)
end

-- The move around an outside corner has the new move's feed and moves the axes outside the plane's space,
-- too.
function ngc:around_corner(item)
  local beside = g.offset_start(item.segment, self.side, self.radius)
  local target = self:complete(item.target)
  for _, letter in ipairs { "x", "y", "z" } do target[letter] = item.source[letter] end
  if item.kind == "rapid" then
    self:output_straight(item, beside, target)
  else
    local corner, turn = item.segment.from, -self.side
    self:output_arc(item, beside, corner, turn, g.sweep_angle(self.at, beside, corner, turn), target)
  end
  self.start = beside
end

function ngc:corner(item)
  local before = self.last.segment
  local waiting = self.queue[1] and self.queue[1].segment   -- nil after a stop
  local beta = outward(before.heading[2], item.segment.heading[1], self.side)
  if is_inside(beta, waiting, item.segment, self.side) then
    self:inside_corner(item)
    return
  end
  if beta > SMALL_CORNER_RAD then
    if item.kind == "arc" then self:empty_queue() else self:end_at(self.tool) end
    self:around_corner(item)
  else
    self:empty_queue()
    self.start = self.tool
  end
end

-- --- The methods of a filter ---

function ngc:take(item)
  if item.segment or not self.last then
    if not self.last then
      if item.kind == "arc" then self:enter_circular(item) else self:enter_straight(item) end
    else
      self:check_fits(item, self.side, self.radius)
      self:corner(item)
      item.point = g.offset_end(item.segment, self.side, self.radius)
      item.centre = item.segment.centre
      item.watched = true
    end
    self.last = item
    self.tool = item.point
  end
  self.queue[#self.queue + 1] = item
end

function ngc:act(f)
  local item = { kind = "act", f = f }
  if #self.queue == 0 then self:put(item) else self.queue[#self.queue + 1] = item end
end

function ngc:flush()
  self:end_at(self.tool)
  self.start = nil
end

return make
