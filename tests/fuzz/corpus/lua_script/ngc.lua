local _ENV = require "gsim.rs274ngc"
G21() G17() G64{p=0.1} F(500)
program(1, function()
G0{x=1,y=2,z=3}
G1{x=10} G3{x=20,y=12,i=0,j=10}
G81{x=5,y=5,z=-3,r=2}  G80()
M2()
end)
