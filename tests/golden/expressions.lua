local _ENV = require "gsim" program(nil, function() -- from expressions.nc; line n there is line n+1 here; hash 7d361757b23ae10b
v[1] = 2.0
v[2] = v[1] + 3.0 * 4.0 - div(5.0, v[1])
v[3] = (v[1] + v[2]) * (-v[1])                          -- (SIGNS)
v[v[1]] = 5.0 v[v[1] + 10.0] = 6.0
v[4] = SIN(30.0) + div(COS(60.0) * TAN(45.0), SQRT(2.0))
v[5] = ATAN(1.0, 2.0)
v[6] = ATAN(1.0) / 2.0
v[7] = 3.0 * ATAN(v[1], v[2]) / 4.0
v[8] = XOR(OR(MOD(10.0, 3.0) + AND(5.0, 3.0), 8.0), 1.0)
v[9] = ROUND(1.5) + ROUND(2.5) - FIX(1.9) - FUP(1.1) + ABS((-3.0))
v[10] = LN(EXP(2.0)) + BIN(16.0) + BCD(16.0)
v[11] = 2.0 - (-3.0)
v[12] = number(v[1] == 2.0) + number(v[1] < 3.0)
v[13] = v[0]
F(v[4] * 100.0) move{x=v[1], y=(-v[2]), z=v[3] + 1.0}
move{x=(-v[1]), y=v[2], z=v[v[1] + 1.0], a=v[v[1]]}
G2{x=10, y=0, i=v[1] / 2.0, ar=v[4]}
M98{p=v[1], l=v[2]}
end)
