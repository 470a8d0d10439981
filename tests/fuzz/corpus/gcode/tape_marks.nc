%
O1 (main)
M98P2
M30
%
%
O2
G1 X1. F60.
M99
%
