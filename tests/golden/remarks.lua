local _ENV = require "gsim" program(nil, function() -- from remarks.nc; line n there is line n+1 here; hash d060891a9fbdf4d2
G21() G91()                                             -- (-beginning)
G4{p=1}                                                 -- (dwell a little)
G0{x=5} F(100) G1{y=5} move{z=3}                        -- N10
M3() if v[1] == 5.0 then goto N7 end                    -- (END of part)
::N7:: move{x=5} goto N7                                -- N7 (x axis)
                                                        -- (whole line remark)
move{x=1}                                               -- (X axis)
end)
