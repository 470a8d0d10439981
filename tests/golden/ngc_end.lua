local _ENV = require "gsim.rs274ngc" program(nil, function() -- from ngc_end.ngc; line n there is line n+1 here; hash 39672202b355c0d3
G0{x=1}                                                 -- N10
if not skipped(1) then M2() end
if truth(v[1]) then
M30()
end
M2()



sub(100, function()                                     -- N20
move{x=2}
end)
move{x=3}
M2()

end)
