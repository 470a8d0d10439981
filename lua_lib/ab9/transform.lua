-- Mirror image (G51.1), scaling (G14.1) and part rotation (G68): linear maps of the program's X, Y and Z
-- before the offsets of the work coordinate system. They act in this order, regardless of the programmed
-- order: the mirror, then the scale, then the rotation. Centres are points of the program, always absolute,
-- so the maps programmed before the centre act on it too.

local dialect = use "core/dialect"
local alarm = use("core/basics", "alarm")
local word = use("core/words", "word")
local ab9_frames, hooks, plane_view, state = dialect.use "frames", use "core/hooks", use "core/plane_view", use "core/state"

local LETTERS = { "x", "y", "z" }
local FACTOR_LETTERS = { x = "i", y = "j", z = "k" }
local MIN_FACTOR = 1e-6

local mirror = {}   -- letter -> coordinate of the plane of symmetry, mm
local scale         -- { factor = {x=,y=,z=}, centre = {x=,y=,z=} in mm } or nil
local rotation      -- { plane, centre = {letter = mm}, angle_deg, frame } or nil
local external = {} -- offset of all work coordinate systems, mm (G10 L2 P0)

local function origin() return { x = 0, y = 0, z = 0 } end

-- Returns a map p -> m*p + shift.
local function identity()
  return { m = { 1, 0, 0, 0, 1, 0, 0, 0, 1 }, shift = origin() }
end

local function apply_map(map, p)
  local m = map.m
  return {
    x = m[1] * p.x + m[2] * p.y + m[3] * p.z + map.shift.x,
    y = m[4] * p.x + m[5] * p.y + m[6] * p.z + map.shift.y,
    z = m[7] * p.x + m[8] * p.y + m[9] * p.z + map.shift.z,
  }
end

local function product(a, b)
  local m = {}
  for row = 0, 2 do
    for column = 1, 3 do
      m[3 * row + column] = a[3 * row + 1] * b[column] + a[3 * row + 2] * b[3 + column] + a[3 * row + 3] * b[6 + column]
    end
  end
  return m
end

-- Returns `map`, followed by the matrix about the image of the centre under `map`.
local function about(map, matrix, centre)
  local c, s = apply_map(map, centre), map.shift
  return {
    m = product(matrix, map.m),
    shift = apply_map({ m = matrix, shift = c }, { x = s.x - c.x, y = s.y - c.y, z = s.z - c.z }),
  }
end

local function diagonal(values)
  return { values.x, 0, 0, 0, values.y, 0, 0, 0, values.z }
end

local function mirror_map(map)
  local signs, centre = { x = 1, y = 1, z = 1 }, origin()
  for letter, at in pairs(mirror) do signs[letter], centre[letter] = -1, at end
  return about(map, diagonal(signs), centre)
end

local place = { x = 1, y = 2, z = 3 }

local function rotate_map(map)
  local p = plane_view.planes[rotation.plane]
  local first, second = place[p.first], place[p.second]
  local c, s = math.cos(math.rad(rotation.angle_deg)), math.sin(math.rad(rotation.angle_deg))
  local m = identity().m
  m[3 * (first - 1) + first], m[3 * (first - 1) + second] = c, -s
  m[3 * (second - 1) + first], m[3 * (second - 1) + second] = s, c
  local centre = origin()
  for letter, value in pairs(rotation.centre) do centre[letter] = value end
  return about(map, m, centre)
end

-- A rotation belongs to the work coordinate system in which it was programmed.
local function is_rotation_active()
  return rotation ~= nil and rotation.frame == state.frame
end

local was_rotating = false   -- whether a rotation acts

local function apply()
  was_rotating = is_rotation_active()
  local map = identity()
  if next(mirror) then map = mirror_map(map) end
  if scale then map = about(map, diagonal(scale.factor), scale.centre) end
  if is_rotation_active() then map = rotate_map(map) end
  for letter, value in pairs(external) do map.shift[letter] = map.shift[letter] + value end
  local plain = not next(mirror) and scale == nil and not is_rotation_active() and not next(external)
  if plain then ab9_frames.set_transform(nil, nil) else ab9_frames.set_transform(map.m, map.shift) end
end

local function number(value, code, letter)
  if type(value) ~= "number" then alarm("script", "%s: the value of '%s' is not a number", code, letter) end
  return value
end

-- Calls use(letter, value in mm) for the words X, Y and Z.
local function for_each_length(words, code, use)
  for _, letter in ipairs(LETTERS) do
    if words[letter] ~= nil then use(letter, number(words[letter], code, letter) * core.unit_mm()) end
  end
end

local function only(words, code, allowed)
  for key in pairs(words or {}) do
    if not allowed:find(" " .. tostring(key) .. " ", 1, true) then
      alarm("word-out-of-place", "%s does not accept the word %s; it accepts%s", code, tostring(key):upper(),
        allowed:upper():sub(1, -2))
    end
  end
  return words or {}
end

-- G51.1 X.. : mirror about X = that value. G50.1: no mirror on the axes named, without words: on no axis.
word("G51_1", function(words)
  words = only(words, "G51.1", " x y z ")
  if next(words) == nil then
    alarm("word-missing", "G51.1 needs the axes to mirror, with the coordinate of the mirror: G51.1 X0")
  end
  for_each_length(words, "G51.1", function(letter, value) mirror[letter] = value end)
  apply()
end)

word("G50_1", function(words)
  words = only(words, "G50.1", " x y z ")
  if next(words) == nil then mirror = {} end
  for_each_length(words, "G50.1", function(letter) mirror[letter] = nil end)
  apply()
end)

local function scale_factor(words, letter, code)
  local key = words[FACTOR_LETTERS[letter]] ~= nil and FACTOR_LETTERS[letter] or words.p ~= nil and "p" or nil
  if key == nil then return 1 end
  local factor = number(words[key], code, key)
  if not (math.abs(factor) >= MIN_FACTOR and math.abs(factor) < math.huge) then
    alarm("frame", "%s %s%.10g: a scale factor must not be 0", code, key:upper(), factor)
  end
  return factor
end

-- Scaling: P for all three axes, I, J, K for one each; X, Y, Z the centre, which is the program's zero point
-- if they are left out. Without words: off.
local function scaling(name, code)
  word(name, function(words)
    words = only(words, code, " p i j k x y z ")
    if next(words) == nil then
      scale = nil
    else
      if words.p == nil and words.i == nil and words.j == nil and words.k == nil then
        alarm("word-missing",
          "%s needs its factor: P for X, Y and Z, or I, J, K for each (without words it ends scaling)", code)
      end
      scale = { factor = {}, centre = origin() }
      for _, letter in ipairs(LETTERS) do scale.factor[letter] = scale_factor(words, letter, code) end
      for_each_length(words, code, function(letter, value) scale.centre[letter] = value end)
    end
    apply()
  end)
end
scaling("G14", "G14")
scaling("G14_1", "G14.1")

-- Returns the centre of a rotation: the axis words of the plane. Missing words keep the active value in this
-- plane, else 0.
local function rotation_centre(words, p)
  local held = is_rotation_active() and rotation.plane == core.plane() and rotation.centre or {}
  local centre = { [p.first] = held[p.first] or 0, [p.second] = held[p.second] or 0 }
  if words[p.third] ~= nil then
    alarm("frame", "G68: %s is not an axis of the active plane; the centre is given by %s and %s", p.third:upper(),
      p.first:upper(), p.second:upper())
  end
  for_each_length(words, "G68", function(letter, value) centre[letter] = value end)
  return centre
end

word("G68", function(words)
  words = only(words, "G68", " x y z r ")
  if words.r == nil then
    alarm("word-missing", "G68 needs R, its angle in degrees (this controller has no table of rotations)")
  end
  local angle = number(words.r, "G68", "r")
  if core.is_incremental() and is_rotation_active() and rotation.plane == core.plane() then angle = angle + rotation.angle_deg end
  rotation = {
    plane = core.plane(), centre = rotation_centre(words, plane_view.planes[core.plane()]), angle_deg = angle,
    frame = state.frame,
  }
  apply()
end)

word("G69", function()
  rotation = nil
  apply()
end)

-- Returns the mirrored axes, by letter.
local function mirrored_axes() return mirror end

-- Returns the offset that all work coordinate systems share, mm.
local function external_offset(letter) return external[letter] or 0 end

local function set_external_offset(letter, value)
  if not place[letter] then alarm("frame", "the external offset has X, Y and Z, not %s", letter:upper()) end
  external[letter] = value ~= 0 and value or nil
  apply()
end

-- A rotation begins or ends to act with a change of work coordinate system.
hooks.on("frame", "rotation", function()
  if was_rotating ~= is_rotation_active() then apply() end
end)

return {
  mirrored_axes = mirrored_axes, external_offset = external_offset, set_external_offset = set_external_offset,
}
