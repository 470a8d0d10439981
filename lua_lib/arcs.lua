-- Circular motion (thesis, Appendix D): by centre, by radius, by angle, and through a point. All cases end in a
-- centre and a swept angle, found without dividing by what can vanish, so that none of them needs special cases.

local SAME_POINT_MM = 1e-6
local SURELY_EQUAL_MM = 0.01   -- below every tolerance of radii
local TURN = 2 * math.pi

-- Axes of each plane in the order in which its angles are counted, and the words of the centre.
planes = {
  xy = { first = "x", second = "y", third = "z", i = "i", j = "j", k = "k" },
  zx = { first = "z", second = "x", third = "y", i = "k", j = "i", k = "j" },
  yz = { first = "y", second = "z", third = "x", i = "j", j = "k", k = "i" },
}

-- By how much the radii of start and end may differ where the centre is given, and R may be too short. In RS274/NGC as
-- LinuxCNC 2.9 has it: 0.0283 mm (0.00283 in), or 0.1 % of the radius where that is more, up to a hundred times that.
local radii_tolerance_mm, short_radius_mm
if core.dialect == "rs274ngc" then
  local LEAST, RELATIVE, MOST = { mm = 0.0283, inch = 0.00283 * 25.4 }, 0.001, 100
  function radii_tolerance_mm(radius)
    local least = state.unit_mm == 1 and LEAST.mm or LEAST.inch
    return math.max(least, math.min(RELATIVE * radius, MOST * least))
  end
  short_radius_mm = 0.00127
else
  function radii_tolerance_mm() return 0.05 end
  short_radius_mm = 0.05
end

local function distance(a, b) return math.sqrt(a * a + b * b) end

-- Angle from the start to the end as seen from the centre, in the sense of travel, in (0, 2 pi].
local function swept(start, finish, centre, ccw)
  local from = math.atan(start[2] - centre[2], start[1] - centre[1])
  local to = math.atan(finish[2] - centre[2], finish[1] - centre[1])
  local angle = (ccw and to - from or from - to) % TURN
  return angle > 0 and angle or TURN
end

local function by_centre(start, finish, centre, ccw)
  local r1 = distance(start[1] - centre[1], start[2] - centre[2])
  local r2 = distance(finish[1] - centre[1], finish[2] - centre[2])
  local difference = math.abs(r1 - r2)
  if difference > SURELY_EQUAL_MM and difference > radii_tolerance_mm(math.max(r1, r2)) then
    alarm("the arc is impossible: its radius is %.6f mm at the start and %.6f mm at the end", r1, r2)
  end
  if r1 < SAME_POINT_MM then alarm("the arc has no radius: its centre is the start") end
  if distance(finish[1] - start[1], finish[2] - start[2]) < SAME_POINT_MM then return centre, TURN end
  return centre, swept(start, finish, centre, ccw)
end

-- The centre stands beside the middle of the chord, at a signed distance to the left of start -> finish.
local function beside_chord(start, finish, left)
  local dx, dy = finish[1] - start[1], finish[2] - start[2]
  local chord = distance(dx, dy)
  return { (start[1] + finish[1]) / 2 - dy / chord * left, (start[2] + finish[2]) / 2 + dx / chord * left }
end

-- R > 0 is the arc of at most half a turn, R < 0 the other one.
local function by_radius(start, finish, radius, ccw)
  local half = distance(finish[1] - start[1], finish[2] - start[2]) / 2
  if half < SAME_POINT_MM / 2 then alarm("a full circle cannot be given by R; give its centre") end
  local r = math.abs(radius)
  if half - r > short_radius_mm then
    alarm("the arc is impossible: R is %.6f mm, but half the distance to the end is %.6f mm", r, half)
  end
  local height = math.sqrt(math.max(r * r - half * half, 0))
  local left = (ccw == (radius > 0)) and height or -height
  local angle = 2 * math.asin(math.min(half / r, 1))
  return beside_chord(start, finish, left), radius > 0 and angle or TURN - angle
end

local function by_angle_and_end(start, finish, angle, ccw)
  local half = distance(finish[1] - start[1], finish[2] - start[2]) / 2
  if half < SAME_POINT_MM / 2 then alarm("an arc by its angle needs an end other than its start, or its centre") end
  if angle >= TURN then alarm("AR= of an arc with an end is below 360 degrees") end
  local left = half / math.tan(angle / 2)
  return beside_chord(start, finish, ccw and left or -left), angle
end

local function turned(start, centre, angle, ccw)
  local c, s = math.cos(angle), math.sin(ccw and angle or -angle)
  local dx, dy = start[1] - centre[1], start[2] - centre[2]
  return { centre[1] + c * dx - s * dy, centre[2] + s * dx + c * dy }
end

local function arc_angle(degrees)
  if type(degrees) ~= "number" or not (degrees > 0 and degrees <= 360) then
    alarm("AR= is an angle above 0 and up to 360 degrees")
  end
  return math.rad(degrees)
end

-- The words that say how the arc is given must not contradict each other.
local function check_words(words, p, has_centre)
  if words.r ~= nil and (has_centre or words.ar ~= nil) then
    alarm("an arc is given by its radius R, or by its centre or its angle, not by both")
  end
  if words[p.k] ~= nil then
    alarm("%s is no centre word of the plane in force; it takes %s and %s", p.k:upper(), p.i:upper(), p.j:upper())
  end
  if words.r == nil and words.ar == nil and not has_centre then
    alarm("an arc needs its centre (%s, %s), its radius (R) or its angle (AR=)", p.i:upper(), p.j:upper())
  end
end

-- The centre by I, J, K: a vector from the start, or where the dialect says so a point of the program.
local function centre_by_words(words, p, start)
  local first, second = (words[p.i] or 0) * state.unit_mm, (words[p.j] or 0) * state.unit_mm
  if state.arc_absolute then
    if words[p.i] == nil or words[p.j] == nil then
      alarm("an absolute arc centre (G90.1) needs both %s and %s", p.i:upper(), p.j:upper())
    end
    local point = core.to_machine { [p.first] = first, [p.second] = second }
    return { point[p.first], point[p.second] }
  end
  if not state.has_matrix then return { start[1] + first, start[2] + second } end
  local a, b = axis_direction(p.first), axis_direction(p.second)
  return {
    start[1] + first * a[p.first] + second * b[p.first],
    start[2] + first * a[p.second] + second * b[p.second],
  }
end

-- Rotation, scaling and mirror image: the factor of the plane's lengths, and whether the sense of turning is kept.
local function plane_map(p)
  local a, b = axis_direction(p.first), axis_direction(p.second)
  local scale = distance(a[p.first], a[p.second])
  local determinant = a[p.first] * b[p.second] - a[p.second] * b[p.first]
  if math.abs(a[p.third]) > 1e-9 or math.abs(b[p.third]) > 1e-9 then
    alarm("an arc in this plane is turned out of it by the rotation in force; cut it in the plane of the rotation")
  end
  if math.abs(math.abs(determinant) - scale * scale) > 1e-9 * scale * scale
    or math.abs(scale - distance(b[p.first], b[p.second])) > 1e-9 * scale then
    alarm("an arc becomes an ellipse where its two axes are scaled differently")
  end
  return scale, determinant > 0
end

local function sweep_of_turns(words, angle)
  local turns = nearly_whole(words.p)
  if turns % 1 ~= 0 or turns < 1 then alarm("P of an arc is its number of turns, a whole number from 1 on") end
  return angle + (turns - 1) * TURN
end

local function arc(ccw, words)
  check_table(words, ccw and "G3" or "G2")
  if words == nil then return end
  local p = planes[state.plane]
  local has_centre = words[p.i] ~= nil or words[p.j] ~= nil
  check_words(words, p, has_centre)
  local resolved = resolve_words(words)
  local target, moved = core.target(resolved, " i j k r ar p ")
  local start = { core.position(p.first), core.position(p.second) }
  local finish = { target[p.first], target[p.second] }
  local scale, same_sense = 1, true
  if state.has_matrix then scale, same_sense = plane_map(p) end
  local turns_left = ccw == same_sense
  local centre, angle
  if has_centre then
    centre = centre_by_words(words, p, start)
    if words.ar ~= nil then
      if resolved[p.first] ~= nil or resolved[p.second] ~= nil then
        alarm("an arc by its angle AR= takes its end or its centre, not both")
      end
      angle = arc_angle(words.ar)
      finish = turned(start, centre, angle, turns_left)
      target[p.first], target[p.second] = finish[1], finish[2]
    else
      centre, angle = by_centre(start, finish, centre, turns_left)
    end
  elseif words.r ~= nil then
    if not moved then alarm("an arc by its radius needs its end") end
    centre, angle = by_radius(start, finish, words.r * state.unit_mm * scale, turns_left)
  else
    centre, angle = by_angle_and_end(start, finish, arc_angle(words.ar), turns_left)
  end
  if words.p ~= nil then angle = sweep_of_turns(words, angle) end
  path.arc(state.plane, turns_left, centre[1], centre[2], angle, target)
end

modal_word("G2", function(words) arc(false, words) end)
modal_word("G3", function(words) arc(true, words) end)

-- CIP: through the point I1=, J1=, K1= (or I, J, K), which is absolute or incremental as the end is. The circle
-- may lie in any plane of space.
local via_words = { x = { "i1", "i" }, y = { "j1", "j" }, z = { "k1", "k" } }

-- Swept angle of the circle through three points, for inverse time feed.
local function swept_via(a, m, b)
  local function angle_at(c, opposite, near, far)  -- inscribed angle, law of cosines
    if near == 0 or far == 0 then return 0 end
    return math.acos(math.max(-1, math.min(1, (near * near + far * far - opposite * opposite) / (2 * near * far))))
  end
  local am, mb, ab = space_between(a, m), space_between(m, b), space_between(a, b)
  return TURN - 2 * angle_at(m, ab, am, mb)
end

local function through_point(words)
  check_table(words, "CIP")
  if words == nil then return end
  local via = {}
  for letter, names in pairs(via_words) do via[letter] = words[names[1]] or words[names[2]] end
  if next(via) == nil then alarm("CIP needs a point on the way: I1=, J1= or K1=") end
  local middle = core.target(via)
  local target = core.target(words, " i j k i1 j1 k1 ")
  if path.is_filtered() then
    alarm("CIP is not possible while something watches or shapes the path (compensation, a corner word, a zone)")
  end
  core.arc_via(middle, target, swept_via(programmed_point(), middle, target))
end

modal_word("CIP", through_point)
