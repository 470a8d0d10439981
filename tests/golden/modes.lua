local _ENV = require "gsim" program(nil, function() -- from modes.nc; line n there is line n+1 here; hash 31c3bdcd2217a0b6
G18() G20() G91() G64() G95()
G15()
G16()
move{x=10, y=45}
G15()
G53() G0{x=0}
G9() G1{x=5}

G505()
G599() G0{x=0}
G59_3()
G52{x=5, y=5}
G92{x=0, y=0, b=0}
G92{x=0} G1()
G92_1()
G28{x=0}
G40() G49() G61() G97() G23() G69() G14() G67()
G14_1()
G98() G80()
end)
