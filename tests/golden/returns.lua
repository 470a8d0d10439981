local _ENV = require "gsim" -- from returns.nc; line n there is line n+1 here; hash 37a63e766018728d
program(1, function() local jump                        -- O1
::N10:: jump = M98({p=2, l=3}, true) if jump then goto computed end -- N10
::N20:: jump = G65({p=2, a=1}, true) if jump then goto computed end -- N20
if v[1] == 1.0 then jump = M98({p=v[5]}, true) if jump then goto computed end end
while v[1] < 3.0 do
jump = M98({p=2}, true) if jump then goto computed0 end
goto pass0 ::computed0:: goto computed ::pass0:: end
if not skipped(1) then goto N10 end
::N30:: M30()                                           -- N30
do return end ::computed:: if jump == 10 then goto N10 end if jump == 20 then goto N20 end if jump == 30 then goto N30 end no_target(jump) end) program(2, function() -- O2
move{x=5}                                               -- N5
do return (M99{p=30}) end
end) program(3, function()                              -- O3
::N5:: move{x=5}                                        -- N5
goto N5
move{x=6} do return (M99{p=v[1]}) end
end)
