O30 (abc)
G0 X1 (x	y)G0 X2
M30
