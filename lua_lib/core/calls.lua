-- Actions around each call of a subprogram.

local alarm = use("core/basics", "alarm")
local hooks, state = use "core/hooks", use "core/state"

local is_ngc = core.dialect == "rs274ngc"
local MAX_DEPTH = is_ngc and 9 or 8
local TOO_DEEP = (is_ngc and "%s call: subroutines" or "%s: programs") .. " are nested more than %d deep"

local on_call, on_return = hooks.listeners "call", hooks.listeners "return"

local calls = {}

-- Begins a call; `arguments` are those of an O-word. The result is for leave().
function calls.enter(name, arguments)
  if state.depth >= MAX_DEPTH then alarm("nesting", TOO_DEEP, name, MAX_DEPTH) end
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
