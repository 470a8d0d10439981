-- Parts of a feed, dwell.

local alarm, copied, given = use("core/basics", "alarm", "copied", "given")
local word = use("core/words", "word")
local path = use "core/path"

-- Returns the same feed for a part of a move: a feed that is a time becomes that part of the time.
local function feed_of_part(feed, part)
  if feed == nil or feed.motion_s == nil then return feed end
  local same = copied(feed)
  same.motion_s = feed.motion_s * part
  return same
end

word("G4", function(words)
  if type(words) ~= "table" then alarm("feed", "G4 requires one of P, X and U, the time in seconds") end
  local seconds = words.p or words.x or words.u
  if given(seconds, "G4") then path.dwell(seconds) end
end)

return { feed_of_part = feed_of_part }
