local _ENV = require "gsim" program(nil, function() -- from corners.nc; line n there is line n+1 here; hash bb3ca7f8e3e1de8c
                                                        -- (chamfers, corner radii, angles of lines)
F(100) corner(2) G1{x=10}
chamfer(1.5) move{y=20}
line_angle(45) corner(v[1] / 2.0) move{x=30}
line_angle(90) move()
line_angle(0) move{x=50, y=40}
chamfer(-1) G3{x=0, y=0, r=50}
if not skipped(2) then corner(v[3]) move{x=1} end
end)
