local _ENV = require "gsim.rs274ngc" program(nil, function() -- from ngc_settings.ngc; line n there is line n+1 here; hash 12ed108d10d531f4
v[1], v[2], p.name, p._globalone = 5.0, (-.5), v[1], v[1] * 2.0
do local w1 = v[1] v[1], v[2] = v[2], v[1] move{x=w1} end
v[1], v[1.0] = 2.0, 1.0
v[v[4] + 1.0], v[v[3]] = (-v[5]), ATAN(1.0, 2.0)
p["end"], p["2nd"] = 1.0, p["end"]
do local w1, w2 = v[1], MOD(v[1], 7.0) v[1] = 3.0 F(w2) G1{x=w1} end
F(POW(POW(2.0, 3.0), 2.0)) S(number(number(1.0 < 2.0) < 3.0)) T(AND(OR(1.0, 2.0), 3.0))
F(POW((-2.0), 2.0)) S(10.0 - 2.0 - 3.0) T(8.0 / 4.0 / 2.0)
move{x=number(equal(v[1], 1.0)), y=number(not equal(v[1], 2.0)) + 1.0, z=AND(v[1], number(v[2] >= 3.0))}
if not skipped(1) then v[1] = 2.0 end
do local w1 = v[5420] F(1.0 + 2.0) G20() G0{y=w1, x=5} end
if not skipped(1) then do local w1 = (-(-p.a)) p.a, v[2] = (-(-3.0)), v[1] + 1.0 DEBUG("%f", v[2]) G91() G1{x=w1} end end -- (debug,#2)
move{x=12.0, y=SIN(AND(MOD(v[1], 2.0), 1.0)), z=v[1]}
end)
