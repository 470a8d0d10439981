local _ENV = require "gsim"
G64() F(6000)
for i = 1, 5 do G1{x=10 * i, y=20 * (i % 2), z=2} end
G2{x=60,y=10,i=5,j=-5} G3{x=50,y=0,r=12} G4{p=0.5} M8() F(900) G1{x=10} M9() M2()
