-- Two robots and a conveyor: gsim-run --robots robots.toml cell.lua
-- The left gantry cuts blanks and lays them on the belt. The right one engraves each on the moving belt as soon as it
-- has come 950 mm. A door that opens interrupts the left one.
local _ENV = require "gsim"

local BLANKS = 3
local belt = conveyor "belt"

device("door", function()
  wait(9)
  signal "door_open"
  wait(2)
  signal("door_open", false)
end)

process("left", function()
  local _ENV = robot "left"
  on_signal("door_open", function() wait_until("door_open", false) end)
  for blank = 1, BLANKS do
    run "left.nc"
    signal("laid" .. blank, belt.position())   -- where on the belt it lies
  end
end)

process("right", function()
  local _ENV = robot "right"
  G21() G90() F(6000)
  for blank = 1, BLANKS do
    wait_until("laid" .. blank)
    local laid = value("laid" .. blank)
    belt.wait_for(laid + 950)
    track "belt"                               -- X0 is now at X0 minus the belt's travel
    local x = 100 - 1000 - laid                -- the corner of the blank in the belt's frame, as this gantry counts
    G0{x=x + 20, y=120}
    G1{x=x + 80}
    G1{y=140}
    G1{x=x + 20}
    G1{y=120}
    track(nil)
    signal("done", blank)
    G0{x=0, y=0}
  end
end)
