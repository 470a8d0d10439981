local _ENV = require "gsim" -- from macros.nc; line n there is line n+1 here; hash a354da0a1fd7f325
                                                        -- (macro calls, user codes, messages, print)
program(1, function()                                   -- O0001
G65{p=9010, a=1, b=-2., c=v[3], x=v[1] + 2.0, f=5, s=6, t=7}
G65{p=9010, {"i", 1}, {"j", 2}, {"k", 3}, {"i", 4}, {"j", 5}, {"k", 6}, a=.5}
G66{p=9010, l=2, z=5}
G66_1{p=9010, e=1, q=2}
G67()
M[101]{p=1, q=v[2]} move{x=5}
M[999]()
if v[1] > 5.0 then message("TOOL \"BROKEN\"") v[3000] = 1.0 end -- (TOOL "BROKEN")
message("load part \\n 2") v[3006] = 1.0                -- (load part \n 2)
POPEN()
DPRNT("X%.3f Y%.0f 100%%", v[100], v[2])
DPRNT("say  \"hello \\")                                -- (note [a])
move{x=1} PCLOS() M30()
end) program(9010, function()                           -- O9010
do return (M99()) end
end)
