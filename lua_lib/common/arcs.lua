-- Circular motion (thesis, Appendix D): by centre, by radius, by angle, and through a point. Plain arcs are
-- C++, which makes them from their words (core.read_arc); the rules of a dialect for them are properties.

local alarm, check_table, distance_in_space = use("core/basics", "alarm", "check_table", "distance_in_space")
local axes, motion, path, polar = use "core/axes", use "common/motion", use "core/path", use "common/polar"

-- Permitted difference of the radii of start and end if the centre is given, and permitted shortness of R.
core.set_arc_rules(use("core/dialect", "arc_rules"))

local function arc(name, ccw)
  local function arc_in_lua(words)
    check_table(words, name)
    if words == nil then return end
    path.arc(core.read_arc(ccw, polar.resolve(words)))
  end
  motion.plain_word(name, function(id) return core.arc_word(ccw, id, name) end,
    function(id) return core.modal_arc_word(ccw, id, name) end, arc_in_lua)
end
arc("G2", false)
arc("G3", true)

-- CIP: through the point I1=, J1=, K1= (or I, J, K), which is absolute or incremental like the end. The
-- circle may lie in any plane of space.
local via_words = { x = { "i1", "i" }, y = { "j1", "j" }, z = { "k1", "k" } }

-- Returns the swept angle of the circle through three points, for inverse time feed.
local function sweep_via(a, m, b)
  local function inscribed_angle(c, opposite, near, far)  -- inscribed angle, law of cosines
    if near == 0 or far == 0 then return 0 end
    return math.acos(math.max(-1, math.min(1, (near * near + far * far - opposite * opposite) / (2 * near * far))))
  end
  local am, mb, ab = distance_in_space(a, m), distance_in_space(m, b), distance_in_space(a, b)
  return 2 * math.pi - 2 * inscribed_angle(m, ab, am, mb)
end

local function through_point(words)
  check_table(words, "CIP")
  if words == nil then return end
  local via = {}
  for letter, names in pairs(via_words) do via[letter] = words[names[1]] or words[names[2]] end
  if next(via) == nil then alarm("word-missing", "CIP requires an intermediate point: I1=, J1= or K1=") end
  local middle = core.target(via)
  local target = core.target(words, " i j k i1 j1 k1 ")
  if path.is_filtered() then
    alarm("mode", "CIP is not possible while the path is monitored or modified (compensation, a corner word)")
  end
  core.arc_via(middle, target, sweep_via(axes.programmed_point(), middle, target))
end

motion.modal_word("CIP", through_point)
