-- RS274/NGC: words of a block apply to all of its codes. In `G64 P2 X20 I5` P is the tolerance of G64 and, if
-- G2 is the modal motion, its turns: move(shared({x=20, i=5}, {p=2})).

local copied = use("core/basics", "copied")
local cycles = use "common/cycles"

local arc_letters, cycle_letters = { "p", "r" }, { "l", "p", "q", "r" }

-- Returns the words of the modal motion, and the words of other codes that it reads too.
function env.shared(words, others)
  local is_arc = core.motion() == "G2" or core.motion() == "G3"
  local letters = is_arc and arc_letters or cycles.is_cycle(core.motion()) and cycle_letters or {}
  local all = copied(words)
  for _, letter in ipairs(letters) do all[letter] = all[letter] or others[letter] end
  return all
end
