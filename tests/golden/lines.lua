local _ENV = require "gsim" -- from lines.nc; line n there is line n+1 here; hash e13d96fc4f97cf01


                                                        -- N10 (BEFORE THE FIRST PROGRAM)
program(7, function()                                   -- O7
move{x=1} move{y=2} move{z=3}


move{x=4}                                               -- (A COMMENT) (ANOTHER)
                                                        -- ()

end) program(8, function() move{x=5} do return (M99()) end -- O8
end)
