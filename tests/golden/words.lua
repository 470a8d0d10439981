local _ENV = require "gsim" program(nil, function() -- from words.nc; line n there is line n+1 here; hash 73e6400a290b8990
F(250) G1{x=1.5, y=-.5, z=5.}
G1{x=5, y=-2}
G1{x=007}
G0{x=0}                                                 -- N10
G17() G40() G80() G90() G54() G94() G0()                -- N20
if not skipped(1) then G1{x=5} end
if not skipped(3) then G1{x=6} end                      -- N40
if not skipped(9) then M8() end                         -- N50
T(5) D(1) H(2) M6()
S(1000) M3()
G91() G55() G93() F(100) S(200) M3() G1{x=5} M9()
move{a=1, b=2, c=3, u=4, v=5, w=6, x=7, y=8, z=9}
move{x=1} M9() M30()
end)
