local _ENV = require "gsim.rs274ngc" program(nil, function() -- from ngc_settings.ngc; line n there is line n+1 here; hash 8582d0471b12a62a
v[1], v[2], p.name, p._globalone = 5.0, (-.5), v[1], v[1] * 2.0
do local s1, s2 = v[2], v[1] move{x=v[1]} v[1], v[2] = s1, s2 end
v[1], v[1.0] = 2.0, 1.0
v[v[4] + 1.0], v[v[3]] = (-v[5]), ATAN(1.0, 2.0)
p["end"], p["2nd"] = 1.0, p["end"]
do local s1 = 3.0 F(MOD(v[1], 7.0)) G1{x=v[1]} v[1] = s1 end
F(POW(POW(2.0, 3.0), 2.0)) S(number(number(1.0 < 2.0) < 3.0)) T(AND(OR(1.0, 2.0), 3.0))
F(POW((-2.0), 2.0)) S(10.0 - 2.0 - 3.0) T(8.0 / 4.0 / 2.0)
move{x=number(equal(v[1], 1.0)), y=number(not equal(v[1], 2.0)) + 1.0, z=AND(v[1], number(v[2] >= 3.0))}
if not skipped(1) then v[1] = 2.0 end
end)
