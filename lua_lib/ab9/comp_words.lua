-- Cutter compensation by the radius of D: G41, G42, and the corners of its path: G39, G39.1.

local alarm = use("core/basics", "alarm")
local check_words, hook_words, offset_radius = use("common/comp_words", "check_words", "hook_words", "offset_radius")
local compensation, dialect, hooks, plane_view =
  use "common/compensation", use "core/dialect", use "core/hooks", use "core/plane_view"
local state, words = use "core/state", use "core/words"

local make_filter = dialect.use "comp"
local word = words.word

-- Returns the radius of the last D.
local function active_radius()
  if not state.offset_number_d then
    alarm("compensation", "cutter compensation needs D, the number of its radius in the tool table")
  end
  return offset_radius(state.offset_number_d, "D")
end

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
      compensation.replace_filter(make_filter(active_radius))
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
