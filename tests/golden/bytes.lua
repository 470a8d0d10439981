local _ENV = require "gsim" program(nil, function() -- from bytes.nc; line n there is line n+1 here; hash 479a5d2b905c12e4
                                                        -- (CR LF, A LONE CR, AND BYTES THAT COULD END A COMMENT OF LUA)
G1{x=1}                                                 -- (A\x0DB)

                                                        -- (--[[ ]] \x1B[0m \x7F)
G1{x=2, y=3}
M2()
end)
