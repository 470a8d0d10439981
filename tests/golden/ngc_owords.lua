local _ENV = require "gsim.rs274ngc" -- from ngc_owords.ngc; line n there is line n+1 here; hash 9ccba9c6b75e3231
sub("drill", function()                                 -- (with a name)
if (v[1] > 0.0) and (not equal(v[2], 5.0)) then
G0{x=v[1]}
while v[1] < 10.0 do
v[1] = v[1] + 1.0
for _ = 1, times(3.0) do
if equal(v[1], 7.0) then
goto break_3
elseif equal(v[1], 8.0) then
goto continue_3
else
break
end
end
::continue_3:: end ::break_3::
else
do return result((-1.0)) end
end
repeat
goto continue_6
::continue_6:: until not (POW(v[2], 2.0) < 5.0)
do return result(p._result) end end)
program(nil, function() call("drill", 1.0 + 2.0, v[5], v[6])
call(v[1] + 100.0)
end) sub(1001, function()
if not skipped(1) then do return end end
end)
more(function() call(1001)                              -- N50
if truth(exists("ab")) then
M2()
end
move{x=1}
end)
