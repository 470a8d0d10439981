local _ENV = require "gsim" -- from programs.nc; line n there is line n+1 here; hash 954693a4cb40085f

program(1, function()                                   -- O0001 (MAIN)
M98{p=2}                                                -- N5
M98{p=3, l=4}
move{x=5} M98{p=3}
M98{p=4711}
M2()

end) program(2, function()                              -- O0002
G1{x=1}
do return (M99()) end

end) program(3, function() move{x=5}                    -- O3
if not skipped(1) then do return (M99()) end end
do return (M99()) end
end) program("WHEEL_2", function()                      -- OWHEEL_2 (A NAME)
do return (M99()) end

end)
