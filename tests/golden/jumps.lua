local _ENV = require "gsim" -- from jumps.nc; line n there is line n+1 here; hash 2abf85f80d71a97c
program(1, function()                                   -- O1 (ONLY TARGETS GET A LABEL)
G0{x=0}                                                 -- N10
::N20:: move{x=1}                                       -- N20
if v[1] == v[0] then goto N20 end
if not skipped(1) then goto N40 end                     -- N30
while 1.0 == 1.0 do
if v[2] > 3.0 then goto N40 end
::N35:: goto N35                                        -- N35
end
::N40:: M2()                                            -- N40
end) program(2, function() local jump                   -- O2 (COMPUTED: ANY N)
::N10:: jump = goto_target(v[1] * 10.0) goto computed   -- N10
::N20:: move{x=1}                                       -- N20
while v[1] < 5.0 do
::N25:: move{x=2}                                       -- N25
jump = goto_target(v[1]) goto computed1
goto pass1 ::computed1:: if jump == 25 then goto N25 end goto computed ::pass1:: end
::N30::                                                 -- N30
do return (M99()) end
do return end ::computed:: if jump == 10 then goto N10 end if jump == 20 then goto N20 end if jump == 30 then goto N30 end no_target(jump) end) program(3, function() -- O3 (NO JUMP, NO LABEL)
move{x=1}                                               -- N10
do return (M99()) end
end)
