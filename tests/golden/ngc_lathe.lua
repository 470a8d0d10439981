local _ENV = require "gsim.rs274ngc" program(nil, function() -- from ngc_lathe.ngc; line n there is line n+1 here; hash 4c2830ab9ea738d1
                                                        -- ( G7 and G8: words X are diameters or radii )
F(300) S(500) M3() G18() G21() G90()
G7() G0{x=40, z=2}
G1{z=-10}
G2{x=50, z=-15, r=5}
G76{p=1, z=-20, i=-1, j=0.4, k=1}
G92{x=60}
v[1] = 8.0
code("G", v[1])
G0{x=20}
M70()
G7()
M72()
G91() move{x=1}
M2()
end)
