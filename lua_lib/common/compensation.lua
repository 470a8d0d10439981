-- Cutter compensation while it is on, for its effect on other words: G40 to G42 and similar words are in
-- common/comp_words.lua.
--
-- The column of the dialect's table (core.codes.compensation) has what LinuxCNC rejects while compensation is
-- on; in addition refuse(what) rejects:
--   G10 L2, L20 of the active system     G18, G19 (G17 if another plane is active)
--   G41, G42, G41.1, G42.1               reading #5420..#5428
-- and allows: G4, G20, G21, G90, G91, G90.1, G91.1, G93..G97, M0, M1, M3..M9, M61, T, S, F. (LinuxCNC allows
-- G92.1 and
-- G92.2 too. Here they are rejected if they would change the offset, because the tool would move on an
-- incorrect path.
-- LinuxCNC ignores G92.3.)
-- The 9/Series leads the tool out and in again if offsets or work coordinate systems change.

local alarm = use("core/basics", "alarm")
local axes, path = use "core/axes", use "core/path"

local compensation = {
  word = nil,     -- the one that holds between G41 or G42 and G40
  plane = nil,    -- in which it was switched on
  filter = nil,   -- path filter: while it is on with a radius, and until a move has led out of it
}

function compensation.refuse(what)
  if compensation.word then
    alarm("compensation", "%s is not possible while cutter compensation is on; program G40 first", what)
  end
end

-- rs274ngc: moves that LinuxCNC never makes next to the path, but permits with a radius of 0.
function compensation.reject_next_to_path(what)
  if compensation.filter then compensation.refuse(what) end
end

-- rs274ngc: a stop (M0, M1, M60) comes when the tool is at the end of the move before it, whatever corner follows.
function compensation.stop()
  if compensation.word and compensation.filter then compensation.filter:flush() end
end

-- rs274ngc: returns the final position of the tool next to the path after all moves so far, in machine
-- coordinates; nil without compensation. After G40 the program's own point counts again.
function compensation.offset_tool_position()
  local filter = compensation.filter
  if not (filter and filter.tool) then return nil end
  local beside = axes.programmed_point()
  filter.view:put(beside, filter.tool)
  return beside
end

-- The new filter is added first, so that the program's point stays separate from the machine's.
function compensation.replace_filter(new)
  local old = compensation.filter
  compensation.filter = new
  if new then path.add_filter(new) end
  if old then path.remove_filter(old) end
end

return compensation
