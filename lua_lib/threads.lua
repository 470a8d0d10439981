-- Moves in step with the spindle: threads and rigid tapping. The feed is the pitch times the speed of the spindle.

local alarm = use("basics", "alarm")
local state = use "state"

-- The feed that cuts `pitch_mm` a turn at the speed in force.
local function thread_feed(pitch_mm, name)
  local rpm = state.spindle_rpm
  if not (pitch_mm > 0) then
    alarm("word-value", "the pitch of %s is a length above 0, not %.10g mm", name, pitch_mm)
  end
  if state.spindle == nil or rpm == nil or rpm == 0 then
    alarm("spindle", "%s moves in step with the spindle, which does not turn (S and M3 or M4)", name)
  end
  local feed = core.feed_mm_min(pitch_mm * rpm)
  feed.linear_mm_rev = pitch_mm
  return feed
end

return { thread_feed = thread_feed }
