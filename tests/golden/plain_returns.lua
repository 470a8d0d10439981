local _ENV = require "gsim" -- from plain_returns.nc; line n there is line n+1 here; hash b751c4378f2a4aee
program(1, function() local jump                        -- O1 (CALLS THAT COME BACK PLAINLY WHERE ANOTHER WAY BACK EXISTS)
jump = M98({p=5}, true) if jump then goto computed end
F(500) G1{x=50}
jump = G65({p=5}, true) if jump then goto computed end
::N30:: G1{x=60}                                        -- N30
v[100] = 2.0
jump = M98({p=5}, true) if jump then goto computed end
move{x=99}
::N40:: M30()                                           -- N40
do return end ::computed:: if jump == 30 then goto N30 end if jump == 40 then goto N40 end no_target(jump) end) program(5, function() -- O5
if v[100] == 2.0 then goto N8 end
G1{y=v[5002] + 1.0}
do return (M99()) end
::N8:: do return (M99{p=40}) end                        -- N8
end)
