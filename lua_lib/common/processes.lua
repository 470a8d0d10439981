-- Processes: several activities on one simulated clock, and the signals between them. A word that joins
-- processes brings the robot to a standstill and continues when no other process is at an earlier time
-- (processes.join).

local alarm = use("core/basics", "alarm")
local programs = use "core/programs"

local processes = core.processes

local function start(background)
  return function(name, f)
    processes.join()
    if type(f) ~= "function" then
      alarm("script", "a process needs a name and a function: process(\"left\", function() ... end)")
    end
    processes.start(name, function()
      f()
      processes.rest()
    end, background)
  end
end
env.process = start(false)
env.device = start(true)

-- Returns the function of the main process: next_script() returns the functions that load the scripts, one
-- after the other.
local function main_process(next_script)
  return function()
    local script = next_script()
    while script do
      script()
      script = next_script()
    end
    programs.run_main_program()
  end
end

-- on_signal(name, f): f() runs between two lines of the process that calls it.
local function run_interrupt(f)
  processes.rest()
  f()
end

function env.on_signal(name, f)
  processes.join()
  processes.on_signal(name, f)
end

function env.wait(seconds) processes.wait(seconds) end

function env.signal(name, value)
  processes.join()
  processes.signal(name, value == nil or value)
end

function env.value(name)
  processes.join()
  return processes.value(name)
end

-- Calls f() until it is true; again after each change of a signal.
local function wait_for(f, seconds)
  local last = seconds and processes.time() + seconds
  while not f() do
    if not processes.wait_signal(nil, "any", nil, last and math.max(last - processes.time(), 0)) then return f() and true or false end
  end
  return true
end

-- wait_until(name [, value [, seconds]]) or wait_until(f [, seconds])
function env.wait_until(what, value, seconds)
  processes.join()
  if type(what) == "function" then return wait_for(what, value) end
  return processes.wait_signal(what, value == nil and "on" or "equals", value, seconds)
end

function env.robot(name) return processes.robot(name) end

-- One process has a shared zone at a time; others wait for it in the order of their requests.
function env.enter_zone(name)
  processes.join()
  processes.enter_zone(name)
end

function env.leave_zone(name)
  processes.join()
  processes.leave_zone(name)
end

-- conveyor(name): returns a table of functions.
function env.conveyor(name)
  processes.conveyor(name)
  local belt = {}
  function belt.position()
    processes.join()
    return processes.conveyor_position(name)
  end
  function belt.speed(mm_s)
    processes.join()
    processes.conveyor_speed(name, mm_s)
  end
  -- Waits until it has travelled that far; a change of its speed is a change of the signal NAME.speed.
  function belt.wait_for(position_mm)
    processes.join()
    while true do
      local seconds = processes.conveyor_reaches(name, position_mm)
      if seconds == 0 then return end
      if not processes.wait_signal(nil, "any", nil, seconds) then return end
    end
  end
  return belt
end

-- Sets the moves that follow to be in the frame of a conveyor; nil: no conveyor.
function env.track(name)
  processes.join()
  processes.track(name)
end

return { main_process = main_process, run_interrupt = run_interrupt }
