-- The spindle. It turns and stops by words, by cycles and with a change of the tool, each of which may switch the
-- machine's process.

local path, process, state = use "path", use "process", use "state"

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

return spindle
