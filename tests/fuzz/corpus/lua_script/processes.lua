local _ENV = require "gsim"
process("mate", function() for i = 1, 4 do wait(0.25) signal("tick", i) end end)
device("door", function() wait(1) signal "open" end)
F(600) G1{x=10}
wait_until("tick", 2, 5)
on_signal("open", function() wait(0.5) end)
G1{x=40}
