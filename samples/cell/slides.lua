-- Two slides that work at one fixture: gsim-run --robots slides.toml slides.lua
-- Each waits in front of it until the other has left.
local _ENV = require "gsim"

local PARTS = 3

for _, name in ipairs { "left", "right" } do
  process(name, function()
    local _ENV = robot(name)
    G21() G90() F(6000)
    for part = 1, PARTS do
      G0{x=250}
      enter_zone "fixture"
      G1{x=350}
      wait(0.5)
      G1{x=250}
      leave_zone "fixture"
      G0{x=0}
    end
  end)
end
