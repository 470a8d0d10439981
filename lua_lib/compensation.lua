-- Cutter compensation: G40, G41, G42 (both dialects), D, G39, G39.1 (9/Series), G41.1, G42.1 (rs274ngc).
--
-- What LinuxCNC refuses while compensation is on, and other words therefore refuse in rs274ngc by
-- refuse_with_compensation(name):
--   G10 L2, L20 of the system in force   G18, G19 (G17 if another plane is in force)
--   G28, G28.1, G30, G30.1, G53          G33, G33.1 (unless the radius is 0)
--   G38.2..5                             G5, G5.1, G73, G76, G81..G89
--   G41, G42, G41.1, G42.1               G43, G43.1, G43.2, G49
--   G52, G92, G54..G59.3                 G61, G61.1, G64, G98, G99
--   M6, M48..M53, M62..M68               reading #5420..#5428
-- and allows: G4, G20, G21, G90, G91, G90.1, G91.1, G93..G97, M0, M1, M3..M9, M61, T, S, F. (It allows G92.1 and
-- G92.2 too; here they are refused where they would change the offset, since the tool would be led wrong. G92.3 it passes
-- over.)
-- The 9/Series leads the tool out and in again where offsets or work coordinate systems change. G10, G27 to G31, G33
-- and cycles are refused there too.

include "comp_geometry"
include "comp_filter"
include "comp_override"
include "comp_ngc"
include "comp_ab9"

local ngc = core.dialect == "rs274ngc"

local filter            -- while on with a radius
local on = false
local plane             -- in which it was switched on

-- `state.compensation` is the name of the word that holds between G41 or G42 and G40, else nil.
function refuse_with_compensation(what)
  if on then alarm("compensation", "%s is not possible while cutter compensation is on; G40 first", what) end
end

-- rs274ngc: moves of which LinuxCNC makes none beside the path, but which a radius of 0 lets through.
function refuse_beside_path(what)
  if filter then refuse_with_compensation(what) end
end

-- rs274ngc: a stop (M0, M1, M60) comes when the tool is at the end of the move before it, whatever corner follows.
function stop_in_compensation()
  if on and filter then filter:flush() end
end

-- rs274ngc: where the tool ends beside the path when all moves so far are done, in machine coordinates; nil
-- without compensation. Behind G40 the program's own point counts again.
function tool_beside_path()
  local point = filter and filter.tool
  if not point then return nil end
  local beside = programmed_point()
  filter.view:put(beside, point)
  return beside
end

-- --- Tools ---

local function radius_of(number, name)
  number = nearly_whole(number)
  if type(number) ~= "number" or number % 1 ~= 0 or number < 0 then
    alarm("compensation", "%s: D is the number of a tool, a whole number from 0 on, not %s", name, tostring(number))
  end
  return tool_diameter_mm(number) / 2
end

-- 9/Series: the radius of the last D.
function comp_radius_in_force()
  if not state.offset_number_d then
    alarm("compensation", "cutter compensation needs D, the number of its radius in the tool table")
  end
  return radius_of(state.offset_number_d, "D")
end

-- --- After G40: the machine stands beside the path until a move leads it out ---

local leaving = comp_filter.derive()

local function leave(self)
  path.remove_filter(self)
  filter = nil
end

-- On the 9/Series moves outside the plane stay beside the path.
function leaving:way_out(target)
  local full = self:complete(target)
  local stays = not ngc and comp_geometry.distance(self:point(self.programmed), self:point(full)) == 0
  self.programmed = full
  return full, stays
end

function leaving:rapid(target, place)
  local full, stays = self:way_out(target)
  self.next:rapid(stays and self:placed(full, self.at) or full, place)
  if not stays then leave(self) end
end

function leaving:line(target, feed, kind, place)
  local full, stays = self:way_out(target)
  self.next:line(stays and self:placed(full, self.at) or full, feed, kind, place)
  if not stays then leave(self) end
end

function leaving:arc()
  alarm("compensation",
    "the first move after G40 leads out of cutter compensation and is straight (G0 or G1), not an arc")
end

function leaving:act(f) self.next:act(f) end

function leaving:flush() end

-- --- Words ---

-- The new filter goes in first, so that the program's point stays apart from the machine's.
local function replace_filter(new)
  local old = filter
  filter = new
  if new then path.add_filter(new) end
  if old then path.remove_filter(old) end
end

local function switch_off()
  on, state.compensation = false, nil
  if not filter then return end
  local entered = filter.before or filter.last
  filter:flush()
  replace_filter(entered and comp_filter.make(leaving, { plane = plane }) or nil)
end

word("G40", function()
  if on then switch_off() end
end)

local function check_words(words, name, allowed)
  check_table(words, name)
  for key in pairs(words or {}) do
    if not allowed[key] then alarm("compensation", "%s does not take %s", name, tostring(key):upper()) end
  end
  return words or {}
end

-- Other words first do what compensation asks of them.
local function before(name, act)
  local meaning = env[name]
  if meaning == nil then return end
  env[name] = function(words)
    act(name)
    meaning(words)
  end
end

before("CIP", refuse_with_compensation)

local function ngc_words()
  -- A radius of 0 counts as compensation and changes no path.
  local function switch_on(name, side, radius, orientation)
    if on then alarm("compensation", "%s: cutter compensation is on already; G40 first", name) end
    if state.plane == "yz" then
      alarm("compensation", "%s: cutter compensation is possible in G17 and G18, not in G19", name)
    end
    on, plane, state.compensation = true, state.plane, name
    if radius < 0 then side, radius = -side, -radius end
    -- In a mirror image left and right change over.
    if not select(2, machine_plane(plane)) then side = -side end
    replace_filter(radius > 0 and comp_ngc(side, radius, orientation) or nil)
  end

  local function by_tool(name, side)
    word(name, function(words)
      words = check_words(words, name, { d = true })
      local number = words.d ~= 0 and words.d or current_tool()   -- D0: the tool in the spindle
      local tool = tool_table[number]
      switch_on(name, side, radius_of(number, name), tool and tool.orientation)
    end)
  end

  local function by_diameter(name, side)
    word(name:sub(1, 3) .. "_1", function(words)
      words = check_words(words, name, { d = true, l = true })
      if type(words.d) ~= "number" then alarm("compensation", "%s needs the diameter of the tool: D", name) end
      if words.l ~= nil and state.plane ~= "zx" then
        alarm("compensation", "%s: L is the orientation of a lathe tool and possible in G18 only", name)
      end
      switch_on(name, side, words.d / 2 * state.unit_mm, words.l)
    end)
  end

  before("M0", stop_in_compensation)
  before("M1", stop_in_compensation)
  -- After a change of tool the program goes on from where the machine stands.
  before("M6", function()
    if not on then replace_filter(nil) end
  end)

  by_tool("G41", 1)
  by_tool("G42", -1)
  by_diameter("G41.1", 1)
  by_diameter("G42.1", -1)
end

local function ab9_words()
  local side, round = 1, false

  -- The last move leads out to its programmed end, and the next one leads in again.
  local function interrupt()
    if on then filter:interrupt() end
  end

  -- A change to this plane: only the one that is in force already.
  local function check_plane(name)
    if on and name ~= plane then refuse_with_compensation("a change of plane") end
  end

  local function define_side(name, new_side)
    word(name, function(words)
      words = check_words(words, name, { d = true })
      check_plane(state.plane)
      if words.d ~= nil then
        radius_of(words.d, name)
        state.offset_number_d = words.d
      end
      side = new_side
      if not on then
        on, plane = true, state.plane
        replace_filter(comp_ab9())
      end
      state.compensation = name
      filter:set(side, round)
    end)
  end

  local function define_corners(name, new_round)
    word(name, function()
      round = new_round
      if on then filter:set(side, round) end
    end)
  end

  -- A rotation that turns the plane takes it out of the one in which the path is led aside.
  local set = set_transform
  function set_transform(...)
    set(...)
    if not on then return end
    local lies, same_sense = machine_plane(plane)
    if not same_plane(lies, filter.lies) then refuse_with_compensation("a rotation that turns its plane") end
    filter.same_sense = same_sense
  end

  before("G17", function() check_plane("xy") end)
  before("G18", function() check_plane("zx") end)
  before("G19", function() check_plane("yz") end)
  for _, name in ipairs { "G52", "G92", "G92_1", "G92_2", "G59_1", "G59_2", "G59_3" } do
    before(name, interrupt)
  end
  for code = 54, 59 do before("G" .. code, interrupt) end
  for code = 505, 599 do before("G" .. code, interrupt) end

  define_side("G41", 1)
  define_side("G42", -1)
  define_corners("G39", false)
  define_corners("G39_1", true)
end

if ngc then ngc_words() else ab9_words() end
