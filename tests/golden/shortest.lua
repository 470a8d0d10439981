local _ENV = require "gsim" program(nil, function() -- from shortest.nc; line n there is line n+1 here; hash 90d40cd8e7697b55
G1{x=5}
end)
