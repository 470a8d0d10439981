-- Output of the program to the outside: DPRNT writes a line of text, between POPEN and PCLOS. Each line is an event.

local open = false

word("POPEN", function()
  open = true
  path.event("print_open")
end)

word("PCLOS", function()
  open = false
  path.event("print_close")
end)

-- DPRNT(format, values ...): a vacant variable is written as 0.
word("DPRNT", function(text, ...)
  if type(text) ~= "string" then alarm("DPRNT takes a text and its values: DPRNT(\"X%%.3f\", v[1])") end
  if not open then alarm("DPRNT has nowhere to write: POPEN comes before the first DPRNT, PCLOS behind the last") end
  local values, count = { ... }, select("#", ...)
  for i = 1, count do
    if values[i] ~= nil and type(values[i]) ~= "number" then alarm("DPRNT: value %d is no number", i) end
    values[i] = values[i] or 0
  end
  local done, line = pcall(string.format, text, table.unpack(values, 1, count))
  if not done then alarm("DPRNT: the text does not fit its values: %s", tostring(line)) end
  path.event("print", line)
end)
