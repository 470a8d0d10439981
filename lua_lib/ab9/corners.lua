-- Chamfers (,C) and corner radii (,R): a corner is between the move that has it and the next one; both lie in
-- the active plane. The move is buffered until the next one is known. In Lua: `corner(2) G1{x=10}`.

local dialect = use "core/dialect"
local alarm, copied, given, distance_in_space = use("core/basics", "alarm", "copied", "given", "distance_in_space")
local feed_of_part = use("common/feed", "feed_of_part")
local word = use("core/words", "word")
local axes, path, plane_geometry, plane_view = use "core/axes", use "core/path", dialect.use "geometry", use "core/plane_view"

local geometry = plane_geometry
local SAME_MM, STRAIGHT = geometry.same_mm, geometry.straight

local WORD_NAMES = { chamfer = ",C", corner = ",R" }

local requested_corner       -- { key, size_mm, plane, place } for the move of the block
local held         -- the pending move, with its corner
local pending_actions = {}    -- what happens between it and the next one

-- Returns values for all axes: those that are not given stay at the start of the move.
local function all_axes(values, move)
  local all = {}
  for _, axis in ipairs(axes.list) do all[axis.letter] = values[axis.letter] or move.start[axis.letter] end
  return all
end

-- Returns the part of the path that a move makes in the plane.
local function element_of(move)
  local view = plane_view.view(move.plane)
  local element = { from = view:at(move.start), to = view:at(all_axes(move.target, move)) }
  if move.arc then
    element.centre, element.sense, element.sweep = { move.first, move.second }, move.ccw and 1 or -1, move.sweep
    element.radius = geometry.length(geometry.minus(element.from, element.centre))
  end
  return element
end

-- Returns the other motion of a move: the letter of an axis, or that it leaves an oblique plane; nil for
-- motion in the plane only.
local function motion_out_of_plane(move, plane)
  local p, view = plane_view.planes[plane], plane_view.view(plane)
  local target = all_axes(move.target, move)
  if math.abs(view:height(target) - view:height(move.start)) > SAME_MM then
    return p and "has a component along " .. p.third:upper() .. " too" or "leaves it"
  end
  for _, axis in ipairs(axes.list) do
    local letter = axis.letter
    local in_space = letter == "x" or letter == "y" or letter == "z"
    if not in_space and math.abs(target[letter] - move.start[letter]) > SAME_MM then
      return "has a component along " .. letter:upper() .. " too"
    end
  end
end

local function check_plane(move, other_plane, mark)
  if move.arc and not plane_view.same_plane(move.plane, other_plane) then
    alarm("corner", "%s must join two moves in one plane; the arc is not in the plane of the previous move", mark)
  end
  local other_motion, p = motion_out_of_plane(move, other_plane), plane_view.planes[other_plane]
  if other_motion == nil then return end
  local where = p and ("the plane of %s and %s"):format(p.first:upper(), p.second:upper()) or "one plane"
  alarm("corner", "%s must join two moves in %s; this move %s", mark, where, other_motion)
end

local filter = { rank = 10 }   -- on the programmed path, before all that shifts it

local function output_move(move, place)
  if move.arc then
    filter.next:arc(move.plane, move.ccw, move.first, move.second, move.sweep, move.target, move.feed, place)
  else
    filter.next:line(move.target, move.feed, move.kind, place)
  end
end

-- Returns the move from one of its points to another; nil as a point is its own start or end. Returns nil if
-- no path is left.
local function move_part(move, element, from, to)
  local begin = from and geometry.along(element, from) or 0
  local finish = to and geometry.along(element, to) or geometry.element_length(element)
  local left = finish - begin
  if left < SAME_MM then return nil end
  from, to = from or element.from, to or element.to
  local view, part = plane_view.view(move.plane), copied(move)
  part.start, part.target = all_axes(move.start, move), all_axes(move.target, move)
  view:put(part.start, from)
  view:put(part.target, to)
  if move.arc then part.sweep = left / element.radius end
  part.feed = feed_of_part(move.feed, left / geometry.element_length(element))
  return part
end

-- Returns the corner itself, with the feed of the first move.
local function corner_move(first, element, corner)
  local move = { plane = first.plane, target = all_axes(first.target, first) }
  plane_view.view(first.plane):put(move.target, corner.to)
  local size = geometry.length(geometry.minus(corner.to, corner.from))
  if corner.centre then
    move.arc, move.ccw, move.first, move.second = true, corner.sense > 0, corner.centre[1], corner.centre[2]
    move.sweep = geometry.sweep_between(corner.from, corner.to, corner.centre, corner.sense)
    size = move.sweep * geometry.length(geometry.minus(corner.from, corner.centre))
  end
  move.feed = feed_of_part(first.feed, size / geometry.element_length(element))
  return move
end

local function output_actions()
  local waiting = pending_actions
  pending_actions = {}
  for _, f in ipairs(waiting) do filter.next:act(f) end
end

local function turn_sense(mark, before, after)
  local turn = geometry.cross(before, after)
  if math.abs(turn) >= STRAIGHT then return turn > 0 and 1 or -1 end
  if geometry.dot(before, after) < 0 then
    alarm("corner", "%s: the next move reverses the direction of this one", mark)
  end
  return 0
end

-- Outputs the pending move up to the corner and the corner. Returns the remainder of the second move, or nil.
-- Moves that continue in one direction have no corner.
local function join(first, second)
  local mark, size = WORD_NAMES[first.corner.key], first.corner.size_mm
  check_plane(second, first.plane, mark)
  second.plane = first.plane
  local a, b = element_of(first), element_of(second)
  local sense = turn_sense(mark, geometry.direction_at(a, a.to), geometry.direction_at(b, b.from))
  if sense == 0 then
    output_move(first, first.place)
    output_actions()
    return second
  end
  local corner = geometry[first.corner.key == "chamfer" and "chamfer" or "rounding"](a, b, size, sense)
  if corner == nil then
    alarm("corner", "%s of %.10g mm does not fit between the two moves, which are %.4f mm and %.4f mm long", mark, size,
      geometry.element_length(a), geometry.element_length(b))
  end
  local start = move_part(first, a, nil, corner.from)
  if start then output_move(start, first.place) end
  output_move(corner_move(first, a, corner), first.place)
  output_actions()
  return move_part(second, b, corner.to, nil)
end

local installed = false

local function install()
  if not installed then path.add_filter(filter) end
  installed = true
end

local function uninstall()
  if held or requested_corner then return end
  installed = false
  path.remove_filter(filter)
end

local function has_motion(move)
  if move.arc then return true end
  for letter, value in unordered(move.target) do
    if math.abs(value - move.start[letter]) > SAME_MM then return true end
  end
  return false
end

local function fail_without_motion(corner) alarm("corner", "%s is in a block without a move", WORD_NAMES[corner.key]) end

local function consume_corner(move)
  local own = requested_corner
  requested_corner = nil
  if own and own.place ~= move.place then fail_without_motion(own) end
  return own
end

-- Receives a move: with a corner of its own it waits, else it is passed on. A move without length is ignored.
local function take(move)
  local own = consume_corner(move)
  move.corner, move.plane = own, move.plane or plane_view.machine_plane(core.plane())
  if not has_motion(move) then
    if own then fail_without_motion(own) end
    return
  end
  if own then check_plane(move, own.plane, WORD_NAMES[own.key]) end
  if held then
    local first = held
    held = nil
    move = join(first, move)
    if move == nil and own then alarm("corner", "%s: the previous corner consumes its complete move", WORD_NAMES[own.key]) end
  end
  if move and own then
    held = move
  elseif move then
    output_move(move, move.place)
  end
end

function filter:line(target, feed, kind, place)
  take { start = axes.programmed_point(), target = target, feed = feed, kind = kind, place = place }
  uninstall()
end

function filter:arc(plane, ccw, first, second, sweep, target, feed, place)
  take {
    start = axes.programmed_point(), arc = true, plane = plane, ccw = ccw, first = first, second = second,
    sweep = sweep, target = target, feed = feed, place = place,
  }
  uninstall()
end

local function fail_if_pending(what)
  if held == nil then return end
  local mark = WORD_NAMES[held.corner.key]
  held = nil
  alarm("corner", "%s must be followed by a feed move (G1, G2, G3), but %s", mark, what)
end

function filter:rapid(target, place)
  if requested_corner and requested_corner.place == place then
    alarm("corner", "%s applies to G1, G2 and G3, not to G0", WORD_NAMES[requested_corner.key])
  end
  fail_if_pending("a rapid follows")
  consume_corner { place = place }
  self.next:rapid(target, place)
  uninstall()
end

function filter:act(f)
  if held then pending_actions[#pending_actions + 1] = f else self.next:act(f) end
end

function filter:flush()
  fail_if_pending("none follows before a standstill")
  if requested_corner then
    local corner = requested_corner
    requested_corner = nil
    fail_without_motion(corner)
  end
end

-- Returns the factor by which scaling changes lengths in a plane.
local function plane_scale(p, mark)
  local function factor(letter) return distance_in_space({}, axes.direction(letter)) end
  local a, b = factor(p.first), factor(p.second)
  if math.abs(a - b) > 1e-9 * a then
    alarm("corner", "%s requires equal scales of both axes of the plane, but they are %.10g and %.10g", mark, a, b)
  end
  return a
end

local function corner_word(key)
  word(key, function(size)
    if not given(size, WORD_NAMES[key]) then return end
    if not (size >= 0 and size < math.huge) then
      alarm("corner", "%s must be a length of 0 or more, not %.10g", WORD_NAMES[key], size)
    end
    if requested_corner and requested_corner.place == core.place() then alarm("corner", "a corner must have ,C or ,R, not both") end
    if requested_corner then fail_without_motion(requested_corner) end
    if size == 0 then return end
    local scale = plane_scale(plane_view.planes[core.plane()], WORD_NAMES[key])
    local plane = plane_view.machine_plane(core.plane())
    requested_corner = { key = key, size_mm = size * core.unit_mm() * scale, plane = plane, place = core.place() }
    install()
  end)
end
corner_word("chamfer")
corner_word("corner")

-- Replaces the corner that is set for the next move, and returns it (nil: no corner).
local function exchange_corner(other)
  local before = requested_corner
  requested_corner = other
  if requested_corner then install() end
  return before
end

return { exchange = exchange_corner }
