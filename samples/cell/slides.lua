-- Two slides that work at one fixture: gsim-run --robots slides.toml slides.lua
-- They take turns: each waits in front of it until the other has left.
local _ENV = require "gsim"

local PARTS = 3

signal("turn", 1)
for number, name in ipairs { "left", "right" } do
  process(name, function()
    local _ENV = robot(name)
    G21() G90() F(6000)
    for part = 1, PARTS do
      G0{x=250}
      wait_until("turn", number)
      G1{x=350}
      wait(0.5)
      G1{x=250}
      signal("turn", 3 - number)
      G0{x=0}
    end
  end)
end
