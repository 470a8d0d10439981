(a program)
O5 (with a title)
G0 X1 (in the middle) Y2 (end)
(nested ] [ # text -- of Lua]])
G4 P1
X5 G04 (the end of the block tells)
M30
