-- Angles of lines (,A, degrees from the plane's first axis). With one coordinate of the plane the other one
-- follows. With no coordinate the line ends at the intersection with the line of the next block, which has ,A
-- and both coordinates. In Lua: `line_angle(30) G1{x=10}`.

local dialect = use "core/dialect"
local alarm, copied, given = use("core/basics", "alarm", "copied", "given")
local word = use("core/words", "word")
local ab9_corners, ab9_macros, axes, motion, path =
  dialect.use "corners", dialect.use "macros", use "core/axes", use "common/motion", use "core/path"
local plane_geometry, plane_view, polar, state = dialect.use "geometry", use "core/plane_view", use "common/polar", use "core/state"

local STRAIGHT = plane_geometry.straight

local angle     -- { degrees, place } of the block being executed, until its motion uses it
-- a line defined only by its angle: { degrees, words, start = {first, second}, plane, rapid, feed, place }
local waiting

local function direction_at_angle(degrees) return { math.cos(math.rad(degrees)), math.sin(math.rad(degrees)) } end

-- Returns the position of the program, in program units.
local function program_point(p)
  local position = axes.program_position()
  return { position[p.first] / core.unit_mm(), position[p.second] / core.unit_mm() }
end

-- One coordinate is given: the other one is on the line.
local function complete(words, p, degrees)
  local way = direction_at_angle(degrees)
  local letters = { p.first, p.second }
  local known = words[p.first] ~= nil and 1 or 2
  if math.abs(way[known]) < STRAIGHT then
    alarm("corner", ",A%.10g: a line at this angle does not change %s", degrees, letters[known]:upper())
  end
  local base = core.is_incremental() and { 0, 0 } or program_point(p)
  local length_on_line = (words[letters[known]] - base[known]) / way[known]
  local full = copied(words)
  full[letters[3 - known]] = base[3 - known] + length_on_line * way[3 - known]
  return full
end

-- Returns the first of two lines with its end at the intersection with the second, which is given by its end
-- and its angle.
local function crossing(words, p, degrees)
  if degrees == nil or words[p.first] == nil or words[p.second] == nil or core.is_incremental() then
    alarm("corner", ",A without an end requires a next block with ,A and both coordinates of the plane, absolute")
  end
  local point = plane_geometry.intersect(
    { from = waiting.start, direction = direction_at_angle(waiting.degrees) },
    { from = { words[p.first], words[p.second] }, direction = direction_at_angle(degrees) })[1]
  if point == nil then
    alarm("corner", "the lines at ,A%.10g and ,A%.10g do not cross: they are parallel", waiting.degrees, degrees)
  end
  local full = copied(waiting.words)
  full[p.first], full[p.second] = point[1], point[2]
  return full
end

-- Filter in the path while an angle waits for its motion or the end of a line is open: all other moves are
-- errors.
local guard = { rank = 5 }
local is_guarding = false

local function guard_path(on)
  if on == is_guarding then return end
  is_guarding = on
  if on then path.add_filter(guard) else path.remove_filter(guard) end
end

local function check_no_open_angle()
  if angle then
    angle = nil
    alarm("corner", ",A requires a straight move (G0, G1) in its block")
  elseif waiting then
    waiting = nil
    alarm("corner", ",A without an end requires a next block with ,A and both coordinates of the plane")
  end
end

function guard:rapid(...)
  check_no_open_angle()
  self.next:rapid(...)
end

function guard:line(...)
  check_no_open_angle()
  self.next:line(...)
end

function guard:arc(...)
  check_no_open_angle()
  self.next:arc(...)
end

function guard:act(f) self.next:act(f) end
function guard:flush() check_no_open_angle() end

local function buffer_line(words, degrees)
  if ab9_macros.modal_code() ~= 67 then alarm("corner", ",A without an end cannot be combined with a modal macro (G66)") end
  local rapid = core.motion() == "G0"
  waiting = {
    degrees = degrees, words = words, start = program_point(plane_view.planes[core.plane()]), plane = core.plane(),
    rapid = rapid, feed = not rapid and core.take_feed() or nil, place = core.place(), corner = ab9_corners.exchange(nil),
  }
end

-- The pending line is output with the feed, the corner and the source location of its own block.
local function output_buffered_line(words)
  local first = waiting
  waiting = nil
  local target = core.target(words)
  local second_corner = ab9_corners.exchange(first.corner)
  if first.rapid then
    guard.next:rapid(target, first.place)
  else
    guard.next:line(target, first.feed, nil, first.place)
  end
  core.set_programmed(target)
  ab9_corners.exchange(second_corner)
end

local function check_words(words)
  if core.motion() ~= "G0" and core.motion() ~= "G1" then alarm("corner", ",A applies to straight moves (G0, G1)") end
  if state.polar then alarm("corner", ",A cannot be combined with polar programming (G16)") end
  for _, letter in ipairs { "u", "v", "w" } do
    if words[letter] ~= nil and axes.is_rotary[letter] == nil then
      alarm("corner", ",A can be combined with X, Y and Z, but not with the increment %s", letter:upper())
    end
  end
end

-- Returns the words of a move to which ,A belongs; nil if it waits for the next one.
local function resolve(words, degrees)
  local p = plane_view.planes[core.plane()]
  if degrees then check_words(words) end
  if waiting then
    if waiting.plane ~= core.plane() then
      alarm("corner", ",A: the plane changes before the end of the line is known")
    end
    output_buffered_line(crossing(words, p, degrees))
    return words
  end
  local has_first, has_second = words[p.first] ~= nil, words[p.second] ~= nil
  if has_first and has_second then
    alarm("corner", ",A with both %s and %s defines the line twice; omit one of them", p.first:upper(), p.second:upper())
  end
  if has_first or has_second then return complete(words, p, degrees) end
  buffer_line(words, degrees)
  return {}
end

-- A motion without axis words, which otherwise has no effect, may be a line defined only by its angle. For
-- one call the words of motion get a table.
local temporary_words = {}
for _, name in ipairs { "G0", "G1", "move" } do
  temporary_words[name] = function(words)
    motion.replace_words("line angle", nil)
    return env[name](words or {})
  end
end

local function resolve_by_angle(words)
  motion.replace_words("line angle", nil)
  local degrees = angle and angle.degrees
  if angle and angle.place ~= core.place() then check_no_open_angle() end
  angle = nil
  local resolved = resolve(words, degrees)
  if waiting == nil then polar.resolve_by(nil) end
  guard_path(waiting ~= nil)
  return resolved
end

word("line_angle", function(degrees)
  if not given(degrees, ",A") then return end
  if angle then check_no_open_angle() end
  angle = { degrees = degrees, place = core.place() }
  polar.resolve_by(resolve_by_angle)
  guard_path(true)
  motion.replace_words("line angle", temporary_words)
end)
