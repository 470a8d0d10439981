local _ENV = require "gsim"
local s, p = rrs.GetCellFrame("tool")
p[3][4] = p[3][4] + 10
print(rrs.ModifyCellFrame("tool", p))
G54() G92{x=1} G52{y=2} F(500) G1{x=5,y=5,z=5,b=10,c=5}
