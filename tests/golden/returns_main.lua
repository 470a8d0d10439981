local _ENV = require "gsim" program(nil, function() local jump -- from returns_main.nc; line n there is line n+1 here; hash 498a372033874686
::N10:: F(100) G1{x=1}                                  -- N10
::N20:: move{x=2}                                       -- N20
if v[1] == 2.0 then goto N10 end
if not skipped(2) then move{x=3} goto N20 end
jump = goto_target(v[1]) goto computed
do return (M99()) end
do return end ::computed:: if jump == 10 then goto N10 end if jump == 20 then goto N20 end no_target(jump) end)
