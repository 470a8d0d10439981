local _ENV = require "gsim" -- from loops.nc; line n there is line n+1 here; hash 5b1aaa6cac00eee4
program(100, function()                                 -- O100 (LOOPS)
v[1] = 0.0
while v[1] < 10.0 do
v[2] = 0.0
while (v[2] < 3.0) and (v[1] ~= 5.0) do                 -- (INNER)
F(500) G1{x=v[1] * 10.0, y=v[2] * 10.0}
v[2] = v[2] + 1.0
end
if v[1] == 7.0 then v[1] = 20.0 end
if v[1] >= 8.0 then G0{z=50} end
if (v[1] > 1.0) or (v[2] <= 0.0) then G4{x=5} end
v[1] = v[1] + 1.0
end
while truth(v[1]) do v[1] = v[1] - 1.0 end
do return (M99()) end
end)
