-- Cutter compensation by tool or by diameter: G41, G42, G41.1, G42.1.

local alarm = use("core/basics", "alarm")
local check_words, hook_words, offset_radius = use("common/comp_words", "check_words", "hook_words", "offset_radius")
local compensation, dialect, plane_view, tools, words =
  use "common/compensation", use "core/dialect", use "core/plane_view", use "common/tools", use "core/words"

local make_filter = dialect.use "comp"
local word = words.word

-- A radius of 0 counts as compensation and changes no path.
local function switch_on(name, side, radius, orientation)
  if compensation.word then alarm("compensation", "%s: cutter compensation is already on; program G40 first", name) end
  if core.plane() == "yz" then
    alarm("compensation", "%s: cutter compensation is possible in G17 and G18, not in G19", name)
  end
  compensation.word, compensation.plane = name, core.plane()
  if radius < 0 then side, radius = -side, -radius end
  -- In a mirror image left and right are exchanged.
  if not select(2, plane_view.machine_plane(core.plane())) then side = -side end
  compensation.replace_filter(radius > 0 and make_filter(side, radius, orientation) or nil)
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
    if type(given.d) ~= "number" then alarm("compensation", "%s needs D, the diameter of the tool", name) end
    if given.l ~= nil and core.plane() ~= "zx" then
      alarm("compensation", "%s: L is the orientation of a lathe tool and is possible only in G18", name)
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
