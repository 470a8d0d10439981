-- Automatic corner override (G62 of the 9/Series). While cutter compensation is on, the tool meets more
-- material in an inside corner than along a straight wall. So the feed is lowered from a distance before the
-- corner to a distance after it. The machine's maker sets the lowered feed, the distances and the corners
-- ([controller] of the machine file).
-- As in Fanuc's manual for the Series 16i (B-63124EN, 5.4.2.1): distances along the tool's own path, not at
-- the corner after the entry move, not with a radius of 0, and not in rapid moves.

local copied = use("core/basics", "copied")
local g, state = use "common/comp_geometry", use "core/state"

local rules = core.corner_override

local comp_override = {}

-- Returns true if the machine's maker has set one.
function comp_override.is_set()
  return rules.percent < 100 and rules.before_mm + rules.after_mm > 0
end

-- Returns true if the feed of the item must be lowered at the corners at its ends. If each move ends at
-- standstill anyway, its parts would too.
function comp_override.is_on(item)
  return comp_override.is_set() and state.path_mode == 62 and item.kind ~= "rapid" and not core.stops_at_each_move
end

-- Marks an inside corner between two items at which the direction changes by `angle`.
function comp_override.mark(p, q, angle)
  if math.pi - math.abs(angle) > math.rad(rules.angle_deg) + 1e-9 or p.radius == 0 then return end
  p.corner_after, q.corner_before = p.overridden, q.overridden
end

local function lower_feed(feed)
  local low = copied(feed)
  for _, key in ipairs { "linear_mm_min", "rotary_deg_min", "linear_mm_rev" } do
    low[key] = feed[key] and feed[key] * rules.percent / 100
  end
  return low
end

-- Returns the ends of the parts of a path of that length, as shares of it, and their feeds. A path that is
-- shorter than its distances from the corners is one part.
function comp_override.parts(item, length_mm)
  local after = item.corner_before and rules.after_mm or 0
  local before = item.corner_after and rules.before_mm or 0
  if after + before == 0 then return { { share = 1, feed = item.feed } } end
  local low = lower_feed(item.feed)
  if after + before >= length_mm then return { { share = 1, feed = low } } end
  local parts = {}
  if after > 0 then parts[1] = { share = after / length_mm, feed = low } end
  parts[#parts + 1] = { share = 1 - before / length_mm, feed = item.feed }
  if before > 0 then parts[#parts + 1] = { share = 1, feed = low } end
  return parts
end

-- Return the point on a straight path or an arc at that share of it.
function comp_override.point_on_line(from, to, share)
  return g.plus(from, g.minus(to, from), share)
end

function comp_override.point_on_arc(from, to, centre, turn, sweep, share)
  local a, r = g.minus(from, centre), g.distance(from, centre)
  local radius = r + (g.distance(to, centre) - r) * share
  local angle = math.atan(a[2], a[1]) + turn * sweep * share
  return { centre[1] + radius * math.cos(angle), centre[2] + radius * math.sin(angle) }
end

return comp_override
