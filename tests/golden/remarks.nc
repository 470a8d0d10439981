G91G21; -beginning
G4 P1 ; dwell a little
G0 X5 ; N10 G1 Y5 F100 ; Z3 ;
M3; IF[#1 EQ 5]GOTO 7; END of part
N7 X5; goto 7 ; x axis
; whole line remark
X1; X axis
