local _ENV = require "gsim" program(nil, function() -- from cycles.nc; line n there is line n+1 here; hash e1398af1ecc86942
                                                        -- (compensation, tool lengths, cycles, transformations, data)
G41{d=5} F(100) G1{x=10}
G42{d=v[7]}
G40() G49()
G43{h=2} G0{z=100}
G99() F(50) G81{x=1, y=2, z=-3, r=1}
move{x=2, l=3}
move{l=3, x=4}
G98() G83{x=5, z=-10, r=1, q=2, p=.5, l=2, k=1}
G80()
G68{x=0, y=0, r=30}
G69()
G14_1{x=0, p=2}
G14()
G51_1{x=0}
G50_1{x=0}
G10{l=2, p=1, x=5, y=6}
G10{l=10, p=3, r=12.5}
G22{x=1, y=2, z=3, i=4, j=5, k=6}
G23()
G28{x=0}
G30{p=2, y=0}
G31{x=50}
G33{z=-20, f=1.5}
G50{s=2000}
G96() S(100)
G59_3() G97()
end)
