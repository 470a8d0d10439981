-- The spindle. It turns and stops by words, by cycles and with a change of the tool, each of which may switch the
-- machine's process; and moves in step with it: threads and rigid tapping.

local alarm = use("core/basics", "alarm")
local path, process, state = use "core/path", use "common/process", use "core/state"

local spindle = {}

local WORDS = { cw = "M3", ccw = "M4" }
local STOP = "M5"

local function turn(direction)
  local changed = state.spindle ~= direction
  state.spindle = direction
  path.event(direction and "spindle_" .. direction or "spindle_off", nil, nil, changed)
end

-- The spindle turns "cw" or "ccw", or stands (nil).
function spindle.turn(direction)
  process.switched_by(WORDS[direction] or STOP, nil, turn, direction)
end

-- Its speed in rev/min: for the feeds of the words that follow at once, for the machine behind the moves so far.
function spindle.set_speed(rpm)
  core.set_spindle(rpm)
  path.act(function() core.set_spindle_speed(rpm) end)
end

local function orient()
  state.spindle = nil
  path.event("spindle_off")
  path.event("spindle_orient")
end

-- It stands still at its marked angle, so that the tool can be moved off the wall.
function spindle.orient()
  process.switched_by(STOP, nil, orient)
end

-- The feed that cuts `pitch_mm` a turn at the speed in force.
function spindle.thread_feed(pitch_mm, name)
  local rpm = core.spindle_rpm()
  if not (pitch_mm > 0) then
    alarm("word-value", "the pitch of %s is a length above 0, not %.10g mm", name, pitch_mm)
  end
  if state.spindle == nil or rpm == 0 then
    alarm("spindle", "%s moves in step with the spindle, which does not turn (S and M3 or M4)", name)
  end
  local feed = core.feed_mm_min(pitch_mm * rpm)
  feed.linear_mm_rev = pitch_mm
  return feed
end

return spindle
