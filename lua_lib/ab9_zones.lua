-- Programmable zone (G22, G23): a box in machine coordinates that the tool must not enter if it stands outside when the
-- zone is switched on, and must not leave if it stands inside. Each move is checked along its whole way. Without a
-- zone nothing stands between the moves and the machine.

local TOUCH_MM = 1e-6   -- nearer than this is on the wall
local TURN = 2 * math.pi

local LETTERS = { "x", "y", "z" }
local OTHER = { x = "i", y = "j", z = "k" }

local box       -- letter -> { low, high } in mm; an axis that is not named has no walls
local inside    -- true: the tool stays in, false: it stays out

-- The box is about the end of the tool: machine coordinates less the tool offset in force.
local function tool_end(point)
  local at = {}
  for _, letter in ipairs(LETTERS) do
    if point[letter] ~= nil then at[letter] = point[letter] - (state.tool_offset[letter] or 0) end
  end
  return at
end

-- Where a move ends; a target may leave axes out, and they stay.
local function there(target)
  local point = {}
  for _, letter in ipairs(LETTERS) do
    if is_rotary[letter] == false then point[letter] = target[letter] or core.machine_position(letter) end
  end
  return tool_end(point)
end

local function here() return there {} end

-- Whether a point is in the zone; its walls belong to it.
local function within(at)
  for letter, walls in pairs(box) do
    if at[letter] < walls[1] - TOUCH_MM or at[letter] > walls[2] + TOUCH_MM then return false end
  end
  return true
end

local function forbidden(at) return within(at) ~= inside end

-- Where along the way, from 0 to 1, each coordinate passes each wall. A way is { at = function(t) -> point,
-- crossings = function(letter, value, add) }.
local function passages(way)
  local found = { { t = 0 } }
  for _, letter in ipairs(LETTERS) do
    for _, value in ipairs(box[letter] or {}) do
      way.crossings(letter, value, function(t)
        if t > 0 and t < 1 then found[#found + 1] = { t = t, letter = letter } end
      end)
    end
  end
  table.sort(found, function(a, b) return a.t < b.t end)
  found[#found + 1] = { t = 1 }
  return found
end

local function walls_text()
  local parts = {}
  for _, letter in ipairs(LETTERS) do
    if box[letter] then
      parts[#parts + 1] = ("%s %.10g to %.10g"):format(letter:upper(), box[letter][1], box[letter][2])
    end
  end
  return table.concat(parts, ", ")
end

local function refuse(at, letter)
  local parts = {}
  for _, name in ipairs(LETTERS) do
    if box[name] then parts[#parts + 1] = ("%s%.4f"):format(name:upper(), at[name]) end
  end
  alarm("the move %s the zone of G22 on axis %s, at %s mm; the zone is %s mm (machine coordinates of the tool's end), "
    .. "and the tool must stay %s it", inside and "leaves" or "enters", letter:upper(), table.concat(parts, " "),
    walls_text(), inside and "inside" or "outside")
end

-- The axis on which a point that is not allowed is nearest to the wall.
local function nearest_wall(at)
  local nearest, distance
  for _, letter in ipairs(LETTERS) do
    if box[letter] then
      local walls = box[letter]
      local depth = math.min(math.abs(at[letter] - walls[1]), math.abs(at[letter] - walls[2]))
      local outside = at[letter] < walls[1] or at[letter] > walls[2]
      if (inside and outside or not inside) and (distance == nil or depth < distance) then
        nearest, distance = letter, depth
      end
    end
  end
  return nearest
end

-- Between two passages the way is on one side: its middle tells which. A touch of a corner or an edge in passing is none.
local function check(way)
  local found = passages(way)
  for i = 1, #found - 1 do
    local middle = way.at((found[i].t + found[i + 1].t) / 2)
    if forbidden(middle) then
      local at = way.at(found[i].t)
      refuse(at, found[i].letter or nearest_wall(at) or nearest_wall(middle))
    end
  end
  local finish = way.at(1)
  if forbidden(finish) then refuse(finish, nearest_wall(finish)) end
end

local function straight(start, finish)
  return {
    at = function(t)
      local point = {}
      for letter in pairs(start) do point[letter] = start[letter] + t * (finish[letter] - start[letter]) end
      return point
    end,
    crossings = function(letter, value, add)
      local way = finish[letter] - start[letter]
      if way ~= 0 then add((value - start[letter]) / way) end
    end,
  }
end

-- Angles at which the circle's coordinate has that value, as fractions of the sweep.
local function circle_crossings(from, sweep, sense, angles, add)
  for _, angle in ipairs(angles) do
    local reached = (sense * (angle - from)) % TURN
    while reached <= sweep do
      add(reached / sweep)
      reached = reached + TURN
    end
  end
end

local function round(plane, ccw, first, second, sweep, start, finish)
  local p = planes[plane]
  local offset = tool_end { [p.first] = first, [p.second] = second }
  local centre = { offset[p.first], offset[p.second] }
  local dx, dy = start[p.first] - centre[1], start[p.second] - centre[2]
  local radius, from, sense = math.sqrt(dx * dx + dy * dy), math.atan(dy, dx), ccw and 1 or -1
  local line = straight(start, finish)
  return {
    at = function(t)
      local point = line.at(t)
      local angle = from + sense * sweep * t
      point[p.first], point[p.second] = centre[1] + radius * math.cos(angle), centre[2] + radius * math.sin(angle)
      return point
    end,
    crossings = function(letter, value, add)
      if letter ~= p.first and letter ~= p.second then return line.crossings(letter, value, add) end
      local side = (value - (letter == p.first and centre[1] or centre[2])) / radius
      if side < -1 or side > 1 then return end
      local angle = letter == p.first and math.acos(side) or math.asin(side)
      circle_crossings(from, sweep, sense, { angle, letter == p.first and -angle or math.pi - angle }, add)
    end,
  }
end

local filter = { rank = 90 }   -- behind all that changes the path

function filter:rapid(target, place)
  check(straight(here(), there(target)))
  self.next:rapid(target, place)
end

function filter:line(target, feed, kind, place)
  check(straight(here(), there(target)))
  self.next:line(target, feed, kind, place)
end

function filter:arc(plane, ccw, first, second, sweep, target, feed, place)
  check(round(plane, ccw, first, second, sweep, here(), there(target)))
  self.next:arc(plane, ccw, first, second, sweep, target, feed, place)
end

function filter:act(f) self.next:act(f) end
function filter:flush() end

local on = false

local function switch(wanted)
  if wanted == on then return end
  on = wanted
  if on then path.add_filter(filter) else path.remove_filter(filter) end
end

local function wall(words, key)
  if type(words[key]) ~= "number" then alarm("G22: the value of '%s' is no number", key) end
  return words[key] * state.unit_mm
end

local function read_box(words)
  local read = {}
  for key in pairs(words) do
    if not (" x y z i j k "):find(" " .. tostring(key) .. " ", 1, true) then
      alarm("G22 takes no word %s; it takes X, Y, Z (one corner) and I, J, K (the other)", tostring(key):upper())
    end
  end
  for _, letter in ipairs(LETTERS) do
    local other = OTHER[letter]
    if (words[letter] == nil) ~= (words[other] == nil) then
      alarm("G22 needs both %s and %s, the two walls of the zone on axis %s", letter:upper(), other:upper(),
        letter:upper())
    end
    if words[letter] ~= nil then
      if is_rotary[letter] ~= false then alarm("G22: the machine has no linear axis %s", letter:upper()) end
      local a, b = wall(words, letter), wall(words, other)
      if math.abs(a - b) <= 2 * TOUCH_MM then
        alarm("G22: the zone has no extent on axis %s, %s and %s are both %.10g mm", letter:upper(), letter:upper(),
          other:upper(), a)
      end
      read[letter] = { math.min(a, b), math.max(a, b) }
    end
  end
  return read
end

-- G22 X Y Z I J K: two opposite corners, in any order; bare: the zone that was given last.
word("G22", function(words)
  check_table(words, "G22")
  if words ~= nil and next(words) ~= nil then box = read_box(words) end
  if box == nil then alarm("G22 needs its zone: X, Y, Z and I, J, K, two opposite corners in machine coordinates") end
  inside = within(here())
  switch(true)
end)

word("G23", function() switch(false) end)
