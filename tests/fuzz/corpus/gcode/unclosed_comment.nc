O25
G0 X1 (never closed
G0 X2
)
G0 X3
M30
