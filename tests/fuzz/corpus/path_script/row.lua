local row = {name = "row"}
for i = 1, 10 do
  row[i] = point{position_mm = {10 * i, 0, 5}, tool_axis = {0, 0, 1}, feed_mm_min = 100}
end
return path{name = "part", repeated(3, path(row))}
