local ok, e = pcall(function() return io.open("/etc/passwd") end)
print(ok, e, string.rep("x", 100))
local t = {a = 1}
print(t.a, #tostring(t), string.format("%5.2f %q", 1/3, "a\n"), table.concat({1,2,3}, ","), select("#", table.unpack({}, 1, 50)))
local c = coroutine.wrap(function() for i = 1, 3 do coroutine.yield(i) end end)
print(c(), c(), utf8 and utf8.char(228))
