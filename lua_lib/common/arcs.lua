-- Circular motion (thesis, Appendix D): by centre, by radius, by angle, and through a point. Plain arcs are
-- C++, which makes them from their words (core.read_arc); the rules of a dialect for them are here.


local alarm, check_table, space_between = use("core/basics", "alarm", "check_table", "space_between")
local axes, motion, path, polar = use "core/axes", use "common/motion", use "core/path", use "common/polar"

-- Permitted difference of the radii of start and end if the centre is given, and permitted shortness of R.
-- For RS274/NGC as in LinuxCNC 2.9: 0.0283 mm (0.00283 in), or 0.1 % of the radius if that is more, up to a
-- hundred times that. A number of turns within 0.0001 of an integer counts as that integer.
if core.dialect == "rs274ngc" then
  core.set_arc_rules {
    radii_tolerance_mm = 0.0283, radii_tolerance_inch_mm = 0.00283 * 25.4, radii_tolerance_share = 0.001,
    radii_tolerance_growth = 100, short_radius_mm = 0.00127, turns_tolerance = 1e-4,
  }
else
  core.set_arc_rules { radii_tolerance_mm = 0.05, radii_tolerance_inch_mm = 0.05, short_radius_mm = 0.05 }
end

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
  local am, mb, ab = space_between(a, m), space_between(m, b), space_between(a, b)
  return 2 * math.pi - 2 * inscribed_angle(m, ab, am, mb)
end

local function through_point(words)
  check_table(words, "CIP")
  if words == nil then return end
  local via = {}
  for letter, names in pairs(via_words) do via[letter] = words[names[1]] or words[names[2]] end
  if next(via) == nil then alarm("word-missing", "CIP needs a point on the way: I1=, J1= or K1=") end
  local middle = core.target(via)
  local target = core.target(words, " i j k i1 j1 k1 ")
  if path.is_filtered() then
    alarm("mode", "CIP is not possible while something watches or shapes the path (compensation, a corner word)")
  end
  core.arc_via(middle, target, sweep_via(axes.programmed_point(), middle, target))
end

motion.modal_word("CIP", through_point)
