local _ENV = require "gsim.rs274ngc" program(nil, function() -- from ngc_words.ngc; line n there is line n+1 here; hash 2c0c2d5720a5f876

                                                        -- ( words: blanks and case mean nothing )
F(100) G17() G21() G90()
G0{x=12.5, y=-3, z=.5}
G1{x=1.0 + 2.0, y=v[1], z=(-p.depth), a=ABS(v[2]), b=(-3.0)} -- N10
G2{x=1, y=2, i=3, j=-4, p=2}
move{x=5, y=6, r=7}
move{radius=5, angle=30}
G5_2{x=1, y=2, p=1, l=3}
move{x=2, y=2, p=2}
G5_3()
G4{p=.5}
G10{l=2, p=1, x=5, r=30}
G33_1{z=-5, k=1, spindle=1}
F(5) G38_2{z=-1}
G43{h=5}
G43_1{z=5}
G53() G0{z=0}
G76{p=1, z=-2, i=-1, j=.5, r=1.5, k=2, q=30, h=2, e=1, l=2}
G81{x=1, y=2, z=-3, r=1, l=4}
G92{x=1}
S(1000) M3{spindle=1} M8() G64{p=.1}
M66{p=0, l=3, q=5}
M[199]{p=1, q=2}
T(5) M6()
if not skipped(1) then move{x=1} end                    -- N90 ( left out)
G94() M5() M9() M48() G20() G40() G55() G90_1() G1{x=1} M0()
end)
