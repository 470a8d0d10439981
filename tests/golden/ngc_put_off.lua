local _ENV = require "gsim.rs274ngc" program(nil, function() -- from ngc_put_off.ngc; line n there is line n+1 here; hash 5b2d6a990aaa3721
sub(100, function()
unknown_code("G777")
unknown_code("M428")
move{x=2}
end)
G0{x=1}
end)
