-- The spindle. Words, cycles and tool changes turn and stop it, and each of them may switch the machine's
-- process. Moves in step with it are threads and rigid tapping.

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

-- Turns the spindle "cw" or "ccw", or stops it (nil).
function spindle.turn(direction)
  process.call_switch_word(WORDS[direction] or STOP, nil, turn, direction)
end

-- Sets its speed in rev/min: for the feeds of the words that follow at once, for the machine after the moves
-- so far.
function spindle.set_speed(rpm)
  core.set_spindle(rpm)
  path.act(function() core.set_spindle_speed(rpm) end)
end

local function orient()
  state.spindle = nil
  path.event("spindle_off")
  path.event("spindle_orient")
end

-- Stops it at its marked angle, so that the tool can be moved off the wall.
function spindle.orient()
  process.call_switch_word(STOP, nil, orient)
end

-- Returns the feed that cuts `pitch_mm` per turn at the active speed.
function spindle.thread_feed(pitch_mm, name)
  local rpm = core.spindle_rpm()
  if not (pitch_mm > 0) then
    alarm("word-value", "the pitch of %s must be greater than 0, not %.10g mm", name, pitch_mm)
  end
  if state.spindle == nil or rpm == 0 then
    alarm("spindle", "%s moves in step with the spindle, which is stopped (program S and M3 or M4)", name)
  end
  local feed = core.feed_mm_min(pitch_mm * rpm)
  feed.linear_mm_rev = pitch_mm
  return feed
end

return spindle
