-- Cutter compensation while it is on, for what it does with other words: G40 to G42 and their kin are in common/comp_words.lua.
--
-- What LinuxCNC refuses while compensation is on is in the column of the dialect's table (core.codes.compensation);
-- beside that, by refuse(what):
--   G10 L2, L20 of the system in force   G18, G19 (G17 if another plane is in force)
--   G41, G42, G41.1, G42.1               reading #5420..#5428
-- and allows: G4, G20, G21, G90, G91, G90.1, G91.1, G93..G97, M0, M1, M3..M9, M61, T, S, F. (It allows G92.1 and
-- G92.2 too; here they are refused where they would change the offset, since the tool would be led wrong. G92.3 it passes
-- over.)
-- The 9/Series leads the tool out and in again where offsets or work coordinate systems change.

local alarm = use("core/basics", "alarm")
local axes, path = use "core/axes", use "core/path"

local compensation = {
  word = nil,     -- the one that holds between G41 or G42 and G40
  plane = nil,    -- in which it was switched on
  filter = nil,   -- of the path: while it is on with a radius, and until a move has led out of it
}

function compensation.refuse(what)
  if compensation.word then
    alarm("compensation", "%s is not possible while cutter compensation is on; G40 first", what)
  end
end

-- rs274ngc: moves of which LinuxCNC makes none beside the path, but which a radius of 0 lets through.
function compensation.refuse_beside_path(what)
  if compensation.filter then compensation.refuse(what) end
end

-- rs274ngc: a stop (M0, M1, M60) comes when the tool is at the end of the move before it, whatever corner follows.
function compensation.stop()
  if compensation.word and compensation.filter then compensation.filter:flush() end
end

-- rs274ngc: where the tool ends beside the path when all moves so far are done, in machine coordinates; nil
-- without compensation. Behind G40 the program's own point counts again.
function compensation.tool_beside_path()
  local filter = compensation.filter
  if not (filter and filter.tool) then return nil end
  local beside = axes.programmed_point()
  filter.view:put(beside, filter.tool)
  return beside
end

-- The new filter goes in first, so that the program's point stays apart from the machine's.
function compensation.replace_filter(new)
  local old = compensation.filter
  compensation.filter = new
  if new then path.add_filter(new) end
  if old then path.remove_filter(old) end
end

return compensation
