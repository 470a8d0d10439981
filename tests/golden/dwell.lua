local _ENV = require "gsim" program(nil, function() -- from dwell.nc; line n there is line n+1 here; hash 2d2c49b15c9b5e55
                                                        -- (WHAT X, U AND P ARE IS TOLD BY THE REST OF THE BLOCK)
G4{x=5}
F(200) G4{x=5}
F(200) move{x=5}
M8() G4{x=5}
G4{u=2.5}
G4{p=3}
G4{p=v[1] / 2.0}
G4{x=v[2]} M9()
F(100) move{x=5, y=6}
end)
