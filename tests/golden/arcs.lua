local _ENV = require "gsim" program(nil, function() -- from arcs.nc; line n there is line n+1 here; hash 364aa8b27ad5b892
                                                        -- (ARCS: CENTRE, RADIUS, ANGLE, THROUGH A POINT, IN ALL PLANES)
G17() G21() G90() G94()
F(1000) G1{x=0, y=0}
G2{x=10, y=10, i=10, j=0}
move{x=20, y=0, i=0, j=-10}                             -- (THE ARC GOES ON)
G3{x=30, y=10, r=10}
move{x=20, y=0, r=-10}
G2{i=-5}                                                -- (FULL CIRCLE)
G3{ar=90, i=0, j=10}
G3{x=0, y=20, ar=45.5}
CIP{x=10, y=10, i1=5, j1=7.5}
G2{x=20, y=10, z=-5, i=5}                               -- (HELIX)
G18() G2{x=5, z=5, k=5, i=0}
G19() G3{y=5, z=5, j=5}
M2()
end)
