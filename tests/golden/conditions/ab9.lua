-- What golden programs find on the machine: a feed, user M codes, a probe.
local _ENV = require "gsim"
M[101] = function(words) v[101] = words.p end
M[102] = M[101]
on_probe(function() return 0.5 end)
F(600)
