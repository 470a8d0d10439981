-- Actions around each call of a subprogram.

local alarm = use("core/basics", "alarm")
local max_depth, nesting_alarm = use("core/dialect", "max_call_depth", "nesting_alarm")
local hooks, state = use "core/hooks", use "core/state"

local on_call, on_return = hooks.listeners "call", hooks.listeners "return"

local calls = {}

-- Begins a call; `arguments` are those of an O-word. The result is for leave().
function calls.enter(name, arguments)
  if state.depth >= max_depth then alarm("nesting", nesting_alarm, name, max_depth) end
  state.depth = state.depth + 1
  core.enter_program(name)
  if #on_call == 0 then return nil end
  local frame = {}
  for i = 1, #on_call do on_call[i].call(frame, arguments) end
  return frame
end

function calls.leave(frame)
  for i = 1, #on_return do on_return[i].call(frame) end
  core.leave_program()
  state.depth = state.depth - 1
end

return calls
