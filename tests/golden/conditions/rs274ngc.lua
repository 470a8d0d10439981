-- What golden programs find on the machine: a feed, user M codes, a probe.
local _ENV = require "gsim.rs274ngc"
M[101] = function(words) v[101] = words.p or 0 end
M[199] = M[101]
on_probe(function() return 0.5 end)
F(600)
