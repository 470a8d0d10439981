-- Output of the program: DPRNT writes a line of text, between POPEN and PCLOS. Each line is an event.

local alarm = use("core/basics", "alarm")
local word = use("core/words", "word")
local path = use "core/path"

local open = false

word("POPEN", function()
  open = true
  path.event("print_open")
end)

word("PCLOS", function()
  open = false
  path.event("print_close")
end)

local PERCENT = ("%"):byte()

-- Values that their "%.3f" shows as 0 are 0, because -0.000 has no use.
local function clear_negative_zeros(text, values)
  local i, at = 0, 1
  while at < #text do
    if text:byte(at) ~= PERCENT then
      at = at + 1
    else
      local escaped = text:byte(at + 1) == PERCENT
      local decimals = text:sub(at + 1, at + 1) == "." and tonumber(text:sub(at + 2, at + 2))
      if not escaped then i = i + 1 end
      if decimals and values[i] and math.abs(values[i]) <= 0.5 * 10 ^ -decimals then values[i] = 0 end
      at = at + 2
    end
  end
end

-- DPRNT(format, values ...): a vacant variable is written as 0.
word("DPRNT", function(text, ...)
  if type(text) ~= "string" then alarm("script", "DPRNT requires a string and its values: DPRNT(\"X%%.3f\", v[1])") end
  if not open then
    alarm("input-output", "DPRNT has no open output: POPEN must precede the first DPRNT, and PCLOS must follow the last one")
  end
  local values, count = { ... }, select("#", ...)
  for i = 1, count do
    if values[i] ~= nil and type(values[i]) ~= "number" then alarm("script", "DPRNT: value %d is not a number", i) end
    values[i] = values[i] or 0
  end
  clear_negative_zeros(text, values)
  local done, line = pcall(string.format, text, table.unpack(values, 1, count))
  if not done then alarm("input-output", "DPRNT: the text does not match its values: %s", tostring(line)) end
  path.event("print", line)
end)
