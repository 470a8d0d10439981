local s = ("a"):rep(300)
print(string.find(s, ("a?"):rep(20) .. ("a"):rep(20)), #s, string.sub(s, 2, 5))
