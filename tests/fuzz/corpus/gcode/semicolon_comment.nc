O5
G4 P1 ; dwell a little
G0 X1;Y2
M30
