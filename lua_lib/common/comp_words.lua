-- Cutter compensation: G40, and what the words of the dialects that switch it on have in common.

local alarm, snap_to_integer = use("core/basics", "alarm", "snap_to_integer")
local keeps_offset_off_plane = use("core/dialect", "keeps_offset_off_plane")
local comp_filter, comp_geometry, compensation =
  use "common/comp_filter", use "common/comp_geometry", use "common/compensation"
local path, tools, words = use "core/path", use "common/tools", use "core/words"

local word = words.word

-- Returns the radius of a tool of the tool table, mm.
local function offset_radius(number, name)
  number = snap_to_integer(number)
  if type(number) ~= "number" or number % 1 ~= 0 or number < 0 then
    alarm("compensation", "%s: D must be a tool number, an integer of at least 0, not %s", name, tostring(number))
  end
  return tools.diameter_mm(number) / 2
end

-- --- After G40: the machine is next to the path until a move leads it out ---

local exit_filter = comp_filter.derive()

local function leave(self)
  path.remove_filter(self)
  compensation.filter = nil
end

function exit_filter:exit_target(target)
  local full = self:complete(target)
  local stays = keeps_offset_off_plane and comp_geometry.distance(self:point(self.programmed), self:point(full)) == 0
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
    "the first move after G40 leaves cutter compensation and must be straight (G0 or G1), not an arc")
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

-- Returns the words, or none; one that is not allowed is an error.
local function check_words(given, name, allowed)
  for key in pairs(given or {}) do
    if not allowed[key] then alarm("compensation", "%s does not accept %s", name, tostring(key):upper()) end
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

return { check_words = check_words, hook_words = hook_words, offset_radius = offset_radius }
