local _ENV = require "gsim.rs274ngc" -- from ngc_put_off.ngc; line n there is line n+1 here; hash 5a083a5cee7cc69b
sub(100, function()
unknown_code("G777")
unknown_code("M428")
move{x=2}
end)
program(nil, function() G0{x=1}
end)
