local _ENV = require "gsim.rs274ngc" program(nil, function() -- from rosette.ngc; line n there is line n+1 here; hash f5f11d3b46378ee2
                                                        -- (Rosette: a circle on a circle, by a subroutine with arguments and a result)
G94() F(3000) G17() G21() G90()
end) sub("petal", function()
                                                        -- (#1 angle in degrees, #2 radius of the circle, #3 radius of the circle on it)
p.reach = v[2] + v[3] * COS(6.0 * v[1])
G1{x=p.reach * COS(v[1]), y=p.reach * SIN(v[1])}
do return result(p.reach) end end)

more(function() G0{x=50, y=0, z=5}
G1{z=-1}
p.angle = 0.0
p.longest = 0.0
while p.angle <= 360.0 do
call("petal", p.angle, 40.0, 10.0)
if p._value > p.longest then
p.longest = p._value
end
p.angle = p.angle + 2.0
end
G0{z=5}
DEBUG("longest reach %.3f mm", parameter("longest"))    -- (DEBUG,longest reach %.3f#<longest> mm)
M2()
end)
