-- G2 and G3 of Klipper: as many chords of equal length as possible with at least arc_resolution_mm each.
-- Every chord is a G1.

local dialect = use "core/dialect"
local alarm, check_table = use("core/basics", "alarm", "check_table")
local word = use("core/words", "word")
local moves, state = dialect.use "moves", dialect.use "state"

-- Planes by their axes. Counterclockwise is from the first to the second axis, so XZ has the opposite sense
-- of the ZX plane of RS274.
local PLANES = {
  xy = { "x", "y", "z", centre = { "i", "j" } },
  xz = { "x", "z", "y", centre = { "i", "k" } },
  yz = { "y", "z", "x", centre = { "j", "k" } },
}
local plane = PLANES.xy

for name, letters in pairs { G17 = "xy", G18 = "xz", G19 = "yz" } do
  word(name, function() plane = PLANES[letters] end)
end

local function refuse(words, name)
  check_table(words, name)
  if words == nil then alarm("arc", "%s: an arc needs its centre", name) end
  if state.incremental then alarm("mode", "%s: Klipper does not support arcs in G91", name) end
  if words.r then alarm("arc", "%s: Klipper does not support arcs by R", name) end
end

-- Returns the program's position and the arc's target, by letter.
local function arc_ends(words)
  local from, to = {}, {}
  for _, letter in ipairs { "x", "y", "z" } do
    from[letter] = state.position(letter) - state.origin(letter)
    to[letter] = words[letter] or from[letter]
  end
  return from, to
end

-- Returns the angle from the start to the end about the centre, which is at the offset (first, second) from
-- the start.
local function arc_sweep(from, to, first, second, clockwise)
  local a, b = plane[1], plane[2]
  local centre_a, centre_b = from[a] + first, from[b] + second
  local to_a, to_b = to[a] - centre_a, to[b] - centre_b
  local sweep = math.atan(-first * to_b + second * to_a, -first * to_a - second * to_b)
  if sweep < 0 then sweep = sweep + 2 * math.pi end
  if clockwise then sweep = sweep - 2 * math.pi end
  if sweep == 0 and from[a] == to[a] and from[b] == to[b] then sweep = 2 * math.pi end
  return sweep
end

-- Returns a function for E along the arc, in equal steps: the E words of the chords.
local function chord_extrusion(words, count)
  if words.e == nil then return function() end end
  if state.incremental_e then return function() return words.e / count end end
  local from = (state.position "e" - state.origin "e") / state.e_factor
  return function(i) return from + i * (words.e - from) / count end
end

local function run_chords(words, clockwise)
  local a, b, along = plane[1], plane[2], plane[3]
  local first, second = words[plane.centre[1]] or 0, words[plane.centre[2]] or 0
  if first == 0 and second == 0 then
    alarm("arc", "an arc in this plane needs its centre in %s and %s", plane.centre[1]:upper(), plane.centre[2]:upper())
  end
  local from, to = arc_ends(words)
  local sweep = arc_sweep(from, to, first, second, clockwise)
  local ascent = to[along] - from[along]
  local length = math.sqrt((math.sqrt(first * first + second * second) * sweep) ^ 2 + ascent * ascent)
  local count = math.max(1, math.floor(length / core.arc_resolution_mm))
  local e_at = chord_extrusion(words, count)
  local centre_a, centre_b = from[a] + first, from[b] + second
  for i = 1, count do
    local chord = { e = e_at(i), f = words.f }
    if i == count then
      chord[a], chord[b], chord[along] = to[a], to[b], to[along]
    else
      local cos, sin = math.cos(i * sweep / count), math.sin(i * sweep / count)
      chord[a] = centre_a - first * cos + second * sin
      chord[b] = centre_b - first * sin - second * cos
      chord[along] = from[along] + i * ascent / count
    end
    moves.line(chord, "G1")
  end
end

for name, clockwise in pairs { G2 = true, G3 = false } do
  word(name, function(words)
    if core.arc_resolution_mm <= 0 then
      core.warn(name .. ": this machine does not support arcs (arc_resolution_mm is 0); they have no effect")
      return
    end
    refuse(words, name)
    run_chords(words, clockwise)
  end)
end
