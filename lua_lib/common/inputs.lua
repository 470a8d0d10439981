-- The controller's own inputs and outputs. They are signals if processes exist: DI1, AI1, DO1 and AO1, or
-- left.DI1 if robots have names.

local alarm = use("core/basics", "alarm")

local processes = core.processes

local inputs = {}

-- on_input(f): the result of f is the value of an input; the dialect defines the arguments.
function env.on_input(f)
  if f ~= nil and type(f) ~= "function" then alarm("script", "on_input needs a function") end
  inputs.handler = f
end

function inputs.io_signal(kind, number) return core.signal_prefix .. kind .. number end

function inputs.set_output(kind, number, value)
  if not processes.several() then return end
  processes.join()
  processes.signal(inputs.io_signal(kind, number), value)
end

-- Returns the present value of an input; nil without processes.
function inputs.input_value(kind, number)
  if not processes.several() then return nil end
  processes.join()
  return processes.value(inputs.io_signal(kind, number))
end

return inputs
