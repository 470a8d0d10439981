local _ENV = require "gsim.rs274ngc" program(nil, function() -- from ngc_end.ngc; line n there is line n+1 here; hash 7d03d18f3af7a520
G0{x=1}                                                 -- N10
if not skipped(1) then M2() end
if truth(v[1]) then
M30()
end
M2()



end) sub(100, function()                                -- N20
move{x=2}
end)



