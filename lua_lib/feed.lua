-- Feed, feed modes, dwell.

word("F", function(value)
  if given(value, "F") then core.set_feed(value) end
end)

local function feed_mode(mode)
  return function()
    state.feed_mode = mode
    core.set_feed_mode(mode)
  end
end
word("G93", feed_mode("inverse"))
word("G94", feed_mode("minute"))
word("G95", feed_mode("revolution"))

-- The same feed for a part of a move: where a feed is a time, it is that part of the time.
function feed_of_part(feed, part)
  if feed == nil or feed.motion_s == nil then return feed end
  local same = copied(feed)
  same.motion_s = feed.motion_s * part
  return same
end

word("G4", function(words)
  if type(words) ~= "table" then alarm("feed", "G4 takes one of P, X and U, its seconds") end
  local seconds = words.p or words.x or words.u
  if given(seconds, "G4") then path.dwell(seconds) end
end)
