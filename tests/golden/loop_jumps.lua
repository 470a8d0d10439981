local _ENV = require "gsim" -- from loop_jumps.nc; line n there is line n+1 here; hash 991913aa4b3f7390
program(1, function() local jump                        -- O1 (A COMPUTED JUMP WITHIN A LOOP)
while v[1] < 3.0 do
v[1] = v[1] + 1.0
jump = goto_target(10.0 * v[1]) goto computed0
::N10:: G1{x=10}                                        -- N10
goto N40
::N20:: move{y=20}                                      -- N20
::N40::                                                 -- N40
goto pass0 ::computed0:: if jump == 10 then goto N10 end if jump == 20 then goto N20 end if jump == 40 then goto N40 end goto computed ::pass0:: end
::N30:: move{x=30}                                      -- N30
do return (M99()) end
do return end ::computed:: if jump == 30 then goto N30 end no_target(jump) end)
