-- RS274/NGC: inputs and outputs. Outputs are events; a function of the script supplies inputs:
--   on_input(function(kind, number, wait, timeout_s) return value, waited_s end)
-- kind is "digital" or "analog"; wait is 0 (the value now), 1 (it rises), 2 (it falls), 3 (it is on) or 4 (it
-- is off). A nil value means that it did not happen in time. Without a function, inputs are signals if the
-- run has processes; otherwise each is 0 at once, as in a dry run of LinuxCNC.

local dialect = use "core/dialect"
local alarm = use("core/basics", "alarm")
local word = use("core/words", "word")
local inputs, parameters, path = use "common/inputs", dialect.use "variables", use "core/path"

local RESULT = 5399
local TIMED_OUT = -1
local MAX_WAIT_MODE = 4
local WITH_MOVE = " with the next move"

local function number_of(value, name, letter)
  local whole = parameters.whole(value)
  if whole == nil or whole < 0 then
    alarm("word-value", "%s needs %s, the number of an input or output, at least 0", name, letter)
  end
  return whole
end

local function digital(name, on, with_move)
  word(name, function(words)
    local number = number_of(words and words.p, name, "P")
    path.event("digital_output", ("P%d %s%s"):format(number, on and "on" or "off", with_move and WITH_MOVE or ""),
               with_move and "with_motion" or "at_rest")
    inputs.set_output("DO", number, on)
  end)
end
digital("M62", true, true)
digital("M63", false, true)
digital("M64", true, false)
digital("M65", false, false)

local function analog(name, with_move)
  word(name, function(words)
    local number = number_of(words and words.e, name, "E")
    if words.q == nil then alarm("word-missing", "%s needs Q, the value of the output", name) end
    path.event("analog_output", ("E%d %.10g%s"):format(number, words.q + 0.0, with_move and WITH_MOVE or ""),
               with_move and "with_motion" or "at_rest")
    inputs.set_output("AO", number, words.q)
  end)
end
analog("M67", true)
analog("M68", false)

local WAIT_CONDITIONS = { "rises", "falls", "on", "off" }

-- Returns the response of other processes: the signal of the input. The robot is idle meanwhile.
local function read_signal(kind, number, wait, timeout)
  local name = kind == "digital" and "DI" or "AI"
  local value = inputs.input_value(name, number)
  if value == nil then return 0, 0 end
  if wait > 0 then
    local signal = inputs.io_signal(name, number)
    if not core.processes.wait_signal(signal, WAIT_CONDITIONS[wait], nil, timeout) then return TIMED_OUT, 0 end
    value = core.processes.value(signal)
  end
  if kind == "digital" then return (value and value ~= 0) and 1 or 0, 0 end
  return value == true and 1 or value or 0, 0
end

local function ask(kind, number, wait, timeout)
  local handler = inputs.handler
  if handler == nil then return read_signal(kind, number, wait, timeout) end
  local value, waited = handler(kind, number, wait, timeout)
  if value == true then value = 1 elseif value == false then value = 0 end
  if value ~= nil and type(value) ~= "number" then
    alarm("script", "the function of on_input must return a number, true, false or nil")
  end
  if value == nil then return TIMED_OUT, timeout end
  return value, math.min(waited or 0, timeout)
end

-- Returns the input that M66 reads: its kind and number.
local function read_input(words)
  if words.p ~= nil and words.e ~= nil then
    alarm("word-out-of-place", "M66 reads a digital input (P) or an analog input (E), not both")
  end
  if words.e ~= nil then return "analog", number_of(words.e, "M66", "E") end
  return "digital", number_of(words.p, "M66", "P or E")
end

word("M66", function(words)
  local kind, number = read_input(words or {})
  local wait, timeout = parameters.whole(words.l or 0), words.q or 0
  if wait == nil or wait < 0 or wait > MAX_WAIT_MODE then
    alarm("word-value", "L of M66 is a wait mode and must be from 0 to %d", MAX_WAIT_MODE)
  end
  if wait ~= 0 and kind == "analog" then alarm("word-value", "M66 reads an analog input immediately: L must be 0") end
  if wait ~= 0 and timeout <= 0 then
    alarm("word-missing", "M66 L%d waits and needs Q, the maximum time in s", wait)
  end
  path.flush()
  local value, waited = ask(kind, number, wait, wait == 0 and 0 or timeout)
  if waited > 0 then path.dwell(waited) end
  parameters.set(RESULT, value)
  path.event("input", ("%s%d: %.10g"):format(kind == "digital" and "P" or "E", number, value))
end)
