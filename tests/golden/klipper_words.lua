local _ENV = require "gsim.klipper" program(nil, function() -- from klipper_words.gcode; line n there is line n+1 here; hash af920e2a9fd04664
                                                        -- (words of Klipper, one command a line)
G21()
G90()                                                   -- (the second one is not read)
G1{x=10, y=5.5, f=1200}                                 -- (out)
G0{x=0, y=0}
G2{x=10, y=0, i=5, j=0}
G4{p=250}
M204{s=800}
SET_VELOCITY_LIMIT{velocity=80, square_corner_velocity=3}
M220{s=90}
M83()
G1{x=20, e=0.5}
G92{e=0}
                                                        -- M6 T2
                                                        -- X40
M400()
                                                        -- M2
end)
