-- Cutter compensation of the 9/Series, type A (G39 to G42). Each move in the plane waits until the next one
-- is known, because its end depends on it:
--   entry      straight to the point next to the start of the move after it
--   inside     the move ends, and the next begins, where the tool has reached both
--   outside    up to 90 degrees the tangents of the tool's paths meet in a point; beyond, each is extended by
--   the
--              radius and a straight block joins them (G39), or an arc about the corner does (G39.1)
--   side       after a change of side a straight block leads over, if the tool's paths do not cross
--   radius     after a new D a line changes to the new radius along its length, an arc in a block before it
--   exit       the last move ends at right angles to itself, and the exit move runs straight to its
--   programmed end

local alarm, copied = use("core/basics", "alarm", "copied")
local comp_filter, g, comp_override = use "common/comp_filter", use "common/comp_geometry", use "common/comp_override"

local LOOK_AHEAD = 20            -- actions and moves outside the plane that may lie between two moves in it
local SMALLEST_BLOCK_MM = 0.001  -- ends at most this far apart are joined by one block
local SAME_POINT_MM = 1e-6
local MAX_ARC_EXCESS_RAD = 0.001       -- by which an arc may come out longer than programmed
local CUSP_RAD = 0.05            -- a turn back by half a turn, within the rounding of coordinates

local ab9 = comp_filter.derive()

local function make(active_radius)
  return comp_filter.make(ab9, {
    plane = core.plane(), side = 1, active_radius = active_radius,
    round = false,        -- G39.1
    before = nil,         -- the last move in the plane
    waiting = false,      -- true if it is still to be output
    between = {},         -- what came after it and is no move in the plane
  })
end

-- --- Output of pending moves ---

-- Returns the moves to output for a path of this length in the plane: the complete move, or parts if the feed
-- is lowered at corners.
function ab9:parts(item, length_mm)
  local rise = self.view:height(item.target) - self.view:height(item.source)
  local parts = comp_override.parts(item, math.sqrt(length_mm * length_mm + rise * rise))
  for i = 1, #parts - 1 do
    parts[i].target = copied(item.target)
    for letter, from in unordered(item.source) do
      parts[i].target[letter] = from + (item.target[letter] - from) * parts[i].share
    end
  end
  return parts
end

function ab9:output_arc_parts(item, point, sweep)
  local from, centre, turn, done = item.begin, item.segment.centre, item.segment.turn, 0
  for _, part in ipairs(self:parts(item, g.distance(from, centre) * sweep)) do
    local to = part.target and comp_override.point_on_arc(from, point, centre, turn, sweep, part.share) or point
    self:output_arc(item, to, centre, turn, sweep * (part.share - done), part.target, part.feed)
    done = part.share
  end
end

local TOO_SHORT_MESSAGE = "%s is too short between its corners, so the tool would move backwards and gouge the path"

function ab9:output_line(item, point)
  if not item.entry and g.dot(item.segment.heading[1], g.minus(point, item.begin)) < -SAME_POINT_MM then
    self:raise_alarm(item, TOO_SHORT_MESSAGE)
  end
  local from = item.begin
  for _, part in ipairs(self:parts(item, g.distance(from, point))) do
    local to = part.target and comp_override.point_on_line(from, point, part.share) or point
    self:output_straight(item, to, part.target, part.feed)
  end
end

function ab9:output_circle(item, point)
  local segment = item.segment
  local sweep = g.swept_after(item.begin, point, segment.centre, segment.turn, segment.sweep)
  if sweep <= segment.sweep + MAX_ARC_EXCESS_RAD then
    self:output_arc_parts(item, point, sweep)
  elseif g.distance(item.begin, point) > SAME_POINT_MM then
    self:raise_alarm(item, TOO_SHORT_MESSAGE)
  end
end

-- Outputs what came after the pending move.
function ab9:output_waiting_items()
  for _, other in ipairs(self.between) do self:output_other(other) end
  self.between, self.waiting = {}, false
end

-- Ends the pending move at that point, and outputs what came after it.
function ab9:finish(point)
  local item = self.before
  if item.kind == "arc" then self:output_circle(item, point) else self:output_line(item, point) end
  self:output_waiting_items()
end

-- Generated blocks: straight through these points, at the feed of the move that follows them, without motion
-- of all other axes.
function ab9:join(item, points)
  for _, point in ipairs(points) do
    if g.distance(self.at, point) > SAME_POINT_MM then self:output_straight(item, point, item.source) end
  end
end

-- --- Corners ---

local function item_offset_end(item) return g.offset_end(item.segment, item.side, item.radius) end

-- Two curves that touch in a reversal: inside if the incoming path is on the tool's side of the outgoing
-- path.
local function is_inside_cusp(p, q, side, angle)
  local curvature_sum = -side * (g.curvature(p) + g.curvature(q))
  if curvature_sum ~= 0 then return curvature_sum > 0 end
  return angle > 0 and angle < math.pi - 1e-9
end

local function is_inside(p, q, side)
  local angle = side * g.angle(p.heading[2], q.heading[1])
  if math.abs(angle) > math.pi - CUSP_RAD then return is_inside_cusp(p, q, side, angle), angle end
  return angle > 0, angle
end

function ab9:inside_corner(p, q, from, to, angle)
  if not self.waiting then
    core.warn(("cutter compensation: the tool moved to the end of a move before the following inside corner was known, "
      .. "and cuts too far there; at most %d actions and moves outside the plane may be in between"):format(LOOK_AHEAD))
    self:join(q, { to })
    return
  end
  local smooth = g.distance(from, to) < SAME_POINT_MM   -- the intersection of curves is not well defined then
  local point = smooth and from or g.intersect(p.segment, q.segment, p.side, p.radius)
  comp_override.mark(p, q, angle)
  if point then
    self:finish(point)
  elseif g.distance(from, to) < SMALLEST_BLOCK_MM then
    self:finish(from)
    self:join(q, { to })
  else
    self:raise_alarm(q, "the tool does not fit into the corner before %s without gouging")
  end
end

function ab9:turn_around(p, q, to)
  local corner, turn = p.segment.to, -p.side
  self:output_arc(q, to, corner, turn, g.sweep_angle(self.at, to, corner, turn), q.source)
end

-- Returns the points that lead around an outside corner between the ends of the two paths: zero, one or two.
local function outside_corner_points(p, q, from, to, angle)
  local d, e = p.segment.heading[2], q.segment.heading[1]
  if g.distance(from, to) < SMALLEST_BLOCK_MM then return {} end
  if math.abs(angle) <= math.pi / 2 + 1e-9 then
    return { g.plus(from, d, p.radius * math.tan(math.abs(angle) / 2)) }
  end
  return { g.plus(from, d, p.radius), g.plus(to, e, -p.radius) }
end

function ab9:outside_corner(p, q, from, to, angle)
  local points = outside_corner_points(p, q, from, to, angle)
  if #points == 2 and self.round and q.kind ~= "rapid" then
    self:close()
    self:turn_around(p, q, to)
    return
  end
  -- A line is extended, instead of adding a block in its own direction after or before it.
  if self.waiting then self:finish(not p.segment.centre and points[1] or from) end
  if q.segment.centre or #points == 0 then points[#points + 1] = to end
  self:join(q, points)
end

-- Returns a point that both of the tool's paths pass, if the side changes between them.
local function crossing(p, q)
  if not p.segment.centre and not q.segment.centre then return nil end
  local best, least
  for _, point in ipairs(g.crossings(p.segment, p.side, p.radius, q.segment, q.side, q.radius)) do
    local function on(segment)
      if segment.centre then return g.within_arc(segment, point) end
      return g.within_line(segment, point)
    end
    local far = g.distance(point, p.segment.to)
    if on(p.segment) and on(q.segment) and (not best or far < least) then best, least = point, far end
  end
  return best
end

function ab9:change_side(p, q)
  local point = self.waiting and crossing(p, q)
  if point then
    self:finish(point)
  else
    if self.waiting then self:finish(item_offset_end(p)) end
    self:join(q, { g.offset_start(q.segment, q.side, q.radius) })
  end
end

-- Moves the tool to the start of an arc with a new radius of compensation.
function ab9:change_radius(p, q)
  if p.radius == q.radius or not q.segment.centre then return end
  local spoke = g.unit(g.minus(self.at, q.segment.centre))
  self:join(q, { g.plus(q.segment.centre, spoke, g.tool_radius(q.segment, q.side, q.radius)) })
end

function ab9:corner(p, q)
  if p.side ~= q.side then
    self:change_side(p, q)
    return
  end
  self:check_fits(q, p.side, p.radius)
  local from, to = item_offset_end(p), g.offset_start(q.segment, p.side, p.radius)
  local inside, angle = is_inside(p.segment, q.segment, p.side)
  if inside then
    self:inside_corner(p, q, from, to, angle)
  else
    self:outside_corner(p, q, from, to, angle)
  end
  self:change_radius(p, q)
end

-- --- Words that change the active state ---

-- A pending last move keeps its own values.
function ab9:set(side, round) self.side, self.round = side, round end

-- The last move ends at right angles next to its programmed end.
function ab9:close()
  if self.waiting then self:finish(item_offset_end(self.before)) end
end

-- The last move leads out to its programmed end, and the next one will lead in: for words that leave the path.
function ab9:interrupt()
  local item = self.before
  if item then
    if self.waiting and item.kind ~= "arc" then
      self:output_straight(item, item.segment.to)
      self:output_waiting_items()
    else
      self:close()
      if item.kind == "arc" then item.kind = "line" end
      self:output_straight(item, item.segment.to)
    end
  end
  self.before = nil
end

-- --- The methods of a filter ---

function ab9:on_other_item(item)
  if not self.waiting then
    self:output_other(item)
    return
  end
  self.between[#self.between + 1] = item
  if #self.between > LOOK_AHEAD then self:close() end
end

function ab9:take(item)
  if not item.segment then
    self:on_other_item(item)
    return
  end
  local radius = self.active_radius()   -- below 0 the sides are swapped
  item.side, item.radius = self.side, math.abs(radius)
  if radius < 0 then item.side = -item.side end
  if not self.same_sense then item.side = -item.side end
  item.overridden = comp_override.is_on(item)
  local before = self.before
  if not before then
    if item.kind == "arc" then
      alarm("compensation",
        "the entry move into cutter compensation must be straight (G0 or G1), not an arc; this is the first move in "
        .. "plane %s after G41 or G42", self.plane:upper())
    end
    item.entry = true
  else
    self:check_fits(item, item.side, item.radius)
    if not before.entry then
      self:corner(before, item)
    else
      local beside = g.offset_start(item.segment, item.side, item.radius)
      if self.waiting then self:finish(beside) else self:join(item, { beside }) end
    end
  end
  item.begin = self.at
  self.before, self.waiting = item, true
end

function ab9:act(f) self:on_other_item({ kind = "act", f = f }) end

function ab9:flush() self:close() end

return make
