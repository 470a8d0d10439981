(chamfers, corner radii, angles of lines)
G1 X10 F100 ,R2
Y20 ,C1.5
X30 ,A45 ,R[#1/2]
,A90
,A 0 X50 Y40
G3 X0 Y0 R50 , c - 1
/2 X1 ,R#3
