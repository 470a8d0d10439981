O27
@ $ ? \ ~ ` ^
Q1 !
"text"
X1 Y
LUA os.exit()
]] end) -- x
M30
