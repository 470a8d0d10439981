-- Automatic corner override (G62 of the 9/Series): while cutter compensation is on, the tool meets more material in an
-- inside corner than along a straight wall, so that the feed is lowered from so far before the corner to so far behind
-- it. What it is lowered to, how far and at which corners, a machine's maker sets ([controller] of the machine file).
-- As in Fanuc's manual for the Series 16i (B-63124EN, 5.4.2.1): distances along the tool's own way, not at the corner
-- behind the entry move, not with a radius of 0, and not in rapid moves.

local copied = use("core/basics", "copied")
local g, state = use "common/comp_geometry", use "core/state"

local rules = core.corner_override

local comp_override = {}

-- The machine's maker has set one.
function comp_override.is_set()
  return rules.percent < 100 and rules.before_mm + rules.after_mm > 0
end

-- Whether the feed of the item is to be lowered at the corners at its ends. Where each move ends at rest anyway, parts
-- of it would too.
function comp_override.is_on(item)
  return comp_override.is_set() and state.path_mode == 62 and item.kind ~= "rapid" and not core.stops_at_each_move
end

-- Between two items is an inside corner at which the direction changes by `angle`.
function comp_override.mark(p, q, angle)
  if math.pi - math.abs(angle) > math.rad(rules.angle_deg) + 1e-9 or p.radius == 0 then return end
  p.corner_behind, q.corner_before = p.overridden, q.overridden
end

local function lowered(feed)
  local low = copied(feed)
  for _, key in ipairs { "linear_mm_min", "rotary_deg_min", "linear_mm_rev" } do
    low[key] = feed[key] and feed[key] * rules.percent / 100
  end
  return low
end

-- Where the parts of a way of that length end, as shares of it, and their feeds. A way that is shorter than its
-- distances from the corners is one part.
function comp_override.parts(item, length_mm)
  local after = item.corner_before and rules.after_mm or 0
  local before = item.corner_behind and rules.before_mm or 0
  if after + before == 0 then return { { share = 1, feed = item.feed } } end
  local low = lowered(item.feed)
  if after + before >= length_mm then return { { share = 1, feed = low } } end
  local parts = {}
  if after > 0 then parts[1] = { share = after / length_mm, feed = low } end
  parts[#parts + 1] = { share = 1 - before / length_mm, feed = item.feed }
  if before > 0 then parts[#parts + 1] = { share = 1, feed = low } end
  return parts
end

-- The point on a straight way or an arc at that share of it.
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
