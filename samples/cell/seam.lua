-- A ring is welded on a turntable by an arm on a track:
-- gsim run samples/cell/seam.lua --machine samples/machines/arm6-cell.toml
-- Poses are on the table, which is coordinated: it turns against the seam's way, so that the torch stands in the world.
local _ENV = require "gsim"

local RADIUS, HEIGHT = 200, 10

local function on_ring(degrees, turntable)
  local angle = math.rad(degrees)
  return { x = RADIUS * math.cos(angle), y = RADIUS * math.sin(angle), z = HEIGHT, roll = degrees, yaw = 180, turntable = turntable }
end

F(1200)
MoveJoint { x = RADIUS, y = 0, z = 60, yaw = 180 }
MoveLinear(on_ring(0))
for quarter = 1, 4 do
  local to = -90 * quarter
  MoveCircular { via = on_ring(to + 45), to = on_ring(to, { z = -to }) }
end

-- A straight seam along the rail: the track carries the arm, which stands on it.
F(6000)
MoveLinear { x = -RADIUS, y = 0, z = HEIGHT, roll = -360, yaw = 180, track = { x = -2 * RADIUS } }

-- The table goes back beside the way up, which is straight in the world: both arrive together.
group("turntable").synchronous()
MoveLinear { x = -RADIUS, y = 0, z = 60, roll = -360, yaw = 180, turntable = { z = 0 } }
