-- Cutter compensation: G40, G41, G42 (both dialects), G39, G39.1 (9/Series), G41.1, G42.1 (rs274ngc).

local alarm, nearly_whole = use("core/basics", "alarm", "nearly_whole")
local comp_ab9, comp_filter, comp_geometry, comp_ngc, compensation, hooks =
  use "ab9/comp", use "common/comp_filter", use "common/comp_geometry", use "rs274ngc/comp", use "common/compensation", use "core/hooks"
local path, plane_view, state, tools, words = use "core/path", use "core/plane_view", use "core/state", use "common/tools", use "core/words"

local word = words.word
local is_ngc = core.dialect == "rs274ngc"

local function offset_radius(number, name)
  number = nearly_whole(number)
  if type(number) ~= "number" or number % 1 ~= 0 or number < 0 then
    alarm("compensation", "%s: D is the number of a tool, a whole number from 0 on, not %s", name, tostring(number))
  end
  return tools.diameter_mm(number) / 2
end

-- 9/Series: the radius of the last D.
local function active_radius()
  if not state.offset_number_d then
    alarm("compensation", "cutter compensation needs D, the number of its radius in the tool table")
  end
  return offset_radius(state.offset_number_d, "D")
end

-- --- After G40: the machine is next to the path until a move leads it out ---

local exit_filter = comp_filter.derive()

local function leave(self)
  path.remove_filter(self)
  compensation.filter = nil
end

-- On the 9/Series moves outside the plane stay next to the path.
function exit_filter:exit_target(target)
  local full = self:complete(target)
  local stays = not is_ngc and comp_geometry.distance(self:point(self.programmed), self:point(full)) == 0
  self.programmed = full
  return full, stays
end

function exit_filter:rapid(target, place)
  local full, stays = self:exit_target(target)
  self.next:rapid(stays and self:placed(full, self.at) or full, place)
  if not stays then leave(self) end
end

function exit_filter:line(target, feed, kind, place)
  local full, stays = self:exit_target(target)
  self.next:line(stays and self:placed(full, self.at) or full, feed, kind, place)
  if not stays then leave(self) end
end

function exit_filter:arc()
  alarm("compensation",
    "the first move after G40 leads out of cutter compensation and is straight (G0 or G1), not an arc")
end

function exit_filter:act(f) self.next:act(f) end

function exit_filter:flush() end

-- --- Words ---

word("G40", function()
  if compensation.word == nil then return end
  compensation.word = nil
  local filter = compensation.filter
  if not filter then return end
  local entered = filter.before or filter.last
  filter:flush()
  compensation.replace_filter(entered and comp_filter.make(exit_filter, { plane = compensation.plane }) or nil)
end)

local function check_words(given, name, allowed)
  for key in pairs(given or {}) do
    if not allowed[key] then alarm("compensation", "%s does not take %s", name, tostring(key):upper()) end
  end
  return given or {}
end

words.before("CIP", "compensation", compensation.refuse)

-- Calls f() before each word that has this entry in the dialect's table.
local function hook_words(what, f)
  local names = {}
  for name, said in unordered(core.codes.compensation) do
    if said == what then names[#names + 1] = name end
  end
  words.before(names, "compensation", f)
end

local function define_ngc_words()
  -- A radius of 0 counts as compensation and changes no path.
  local function switch_on(name, side, radius, orientation)
    if compensation.word then alarm("compensation", "%s: cutter compensation is on already; G40 first", name) end
    if core.plane() == "yz" then
      alarm("compensation", "%s: cutter compensation is possible in G17 and G18, not in G19", name)
    end
    compensation.word, compensation.plane = name, core.plane()
    if radius < 0 then side, radius = -side, -radius end
    -- In a mirror image left and right are exchanged.
    if not select(2, plane_view.machine_plane(core.plane())) then side = -side end
    compensation.replace_filter(radius > 0 and comp_ngc(side, radius, orientation) or nil)
  end

  local function define_by_tool(name, side)
    word(name, function(given)
      given = check_words(given, name, { d = true })
      local number = given.d ~= 0 and given.d or tools.loaded()   -- D0: the tool in the spindle
      local tool = tools.by_number[number]
      switch_on(name, side, offset_radius(number, name), tool and tool.orientation)
    end)
  end

  local function define_by_diameter(name, side)
    word(name:sub(1, 3) .. "_1", function(given)
      given = check_words(given, name, { d = true, l = true })
      if type(given.d) ~= "number" then alarm("compensation", "%s needs the diameter of the tool: D", name) end
      if given.l ~= nil and core.plane() ~= "zx" then
        alarm("compensation", "%s: L is the orientation of a lathe tool and possible in G18 only", name)
      end
      switch_on(name, side, given.d / 2 * core.unit_mm(), given.l)
    end)
  end

  hook_words("ends the move", compensation.stop)
  -- After a tool change the program continues from the present position of the machine.
  words.before("M6", "compensation", function()
    if compensation.word == nil then compensation.replace_filter(nil) end
  end)

  define_by_tool("G41", 1)
  define_by_tool("G42", -1)
  define_by_diameter("G41.1", 1)
  define_by_diameter("G42.1", -1)
end

local function define_ab9_words()
  local side, round = 1, false

  -- The last move leads out to its programmed end, and the next one leads in again.
  local function interrupt()
    if compensation.word then compensation.filter:interrupt() end
  end

  local function define_side(name, new_side)
    word(name, function(given)
      given = check_words(given, name, { d = true })
      if given.d ~= nil then
        offset_radius(given.d, name)
        state.offset_number_d = given.d
      end
      side = new_side
      if compensation.word == nil then
        compensation.plane = core.plane()
        compensation.replace_filter(comp_ab9(active_radius))
      end
      compensation.word = name
      compensation.filter:set(side, round)
    end)
  end

  local function define_corners(name, new_round)
    word(name, function()
      round = new_round
      if compensation.word then compensation.filter:set(side, round) end
    end)
  end

  -- A rotation that turns the plane moves it out of the plane in which the path is offset.
  hooks.on("transform", "compensation", function()
    if compensation.word == nil then return end
    local machine_plane_of_path, same_sense = plane_view.machine_plane(compensation.plane)
    local stays = plane_view.same_plane(machine_plane_of_path, compensation.filter.machine_plane_of_path)
    if not stays then compensation.refuse("a rotation that turns its plane") end
    compensation.filter.same_sense = same_sense
  end)

  -- Only the plane that is already active.
  for name, plane in pairs { G17 = "xy", G18 = "zx", G19 = "yz" } do
    words.before(name, "compensation", function()
      if plane ~= compensation.plane then compensation.refuse("a change of plane") end
    end)
  end
  hook_words("led out", interrupt)

  define_side("G41", 1)
  define_side("G42", -1)
  define_corners("G39", false)
  define_corners("G39_1", true)
end

if is_ngc then define_ngc_words() else define_ab9_words() end
