-- Home positions: G28 and G30 move there by an intermediate point, G29 returns by the same point, G27 checks;
-- and the skip function G31. The first home is that of the machine file, the second to fourth are in
-- `core.homes`: those of machine data, else of the machine file.

local alarm = use("core/basics", "alarm")
local word = use("core/words", "word")
local axes, move_until_signal, path = use "core/axes", use "common/probe", use "core/path"

local SAME = 1e-6   -- mm or deg

local way   -- letter -> machine coordinate of the intermediate point, for the axes that G28 or G30 named

local increment = { x = "u", y = "v", z = "w" }

local function is_named(words, letter)
  return words == nil or words[letter] ~= nil or words[increment[letter]] ~= nil
end

local function homes(number)
  if number == 1 then
    local first = {}
    for _, axis in ipairs(axes.list) do first[axis.letter] = axis.home end
    return first
  end
  local stored = core.homes[number]
  if stored == nil then
    alarm("home",
      "G30 P%d: home position %d is not defined; define it in the section HOME of machine data, or in the machine file",
      number, number)
  end
  return stored
end

-- Returns a target for all axes of which only these change.
local function complete_target(values)
  local target = axes.programmed_point()
  for letter, value in pairs(values) do target[letter] = value end
  return target
end

local function move_home(words, number, code)
  axes.reject_with_tcp_control(code)
  local home, target = homes(number), {}
  for _, axis in ipairs(axes.list) do
    if is_named(words, axis.letter) then
      target[axis.letter] = home[axis.letter]
      if target[axis.letter] == nil then
        alarm("home", "%s P%d: home position %d has no value for axis %s", code, number, number, axis.letter:upper())
      end
    end
  end
  way = nil
  if words ~= nil then
    local point = core.target(words)
    path.rapid(point)
    way = {}
    for letter in pairs(target) do way[letter] = point[letter] end
  end
  for letter, value in pairs(target) do target[letter] = core.turned(letter, value) end
  path.rapid(complete_target(target))
end

word("G28", function(words) move_home(words, 1, "G28") end)

word("G30", function(words)
  local rest, number = nil, 2
  for key, value in pairs(words or {}) do
    if key == "p" then
      number = value
    else
      rest = rest or {}
      rest[key] = value
    end
  end
  if type(number) ~= "number" or number % 1 ~= 0 or number < 2 or number > 4 then
    alarm("home", "G30: P must be the number of a home position, 2 to 4, not %s", tostring(number))
  end
  move_home(rest, math.tointeger(number), "G30")
end)

-- G29 moves the axes that it names; an increment counts from the intermediate point.
word("G29", function(words)
  if words == nil then alarm("word-missing", "G29 requires the axis words of its target") end
  axes.reject_with_tcp_control("G29")
  local through = {}
  for letter, value in pairs(way or {}) do
    if is_named(words, letter) then through[letter] = value end
  end
  if next(through) then path.rapid(complete_target(through)) end
  path.rapid(core.target(words))
end)

word("G27", function(words)
  axes.reject_with_tcp_control("G27")
  if words ~= nil then path.rapid(core.target(words)) end
  path.flush()
  for _, axis in ipairs(axes.list) do
    local position = core.machine_position(axis.letter)
    local home = core.turned(axis.letter, axis.home)
    if is_named(words, axis.letter) and math.abs(position - home) > SAME then
      alarm("home", "G27: axis %s is at %.10g, not at its home %.10g", axis.letter:upper(), position, axis.home)
    end
  end
end)

local skipped_at   -- machine coordinates by axis letter

-- Returns the position of the last skip signal, machine coordinates; nil before the first G31.
local function skip_position() return skipped_at end

-- G31: a straight move that a signal ends early. Without a signal it runs to its end, and that is the skip
-- position. With a signal it is the position of the signal, a little before the final position of the
-- machine.
word("G31", function(words)
  local target, named = core.target(words)
  if not named then alarm("word-missing", "G31 requires the axis words of its target") end
  local _, _, point = move_until_signal(target, false)
  skipped_at = point
end)

return { skip_position = skip_position }
