(A blank of 100 by 60, cut by the left gantry)
G21 G90
G0 X100 Y100
M8
G1 X200 F3000
Y160
X100
Y100
M9
M30
