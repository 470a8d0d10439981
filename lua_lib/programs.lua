-- Programs, subprograms, and the end of a run.

local MAX_DEPTH = 8
local MOST = 2^31 - 1     -- of a program number, and of repeats
local TO_START = "M99"   -- what a program returns where it ends in M99

local programs = {}
local first

-- program(number or nil, function): a program of this file; the first one of the file runs once the file is loaded.
function env.program(name, body)
  first = first or body
  if name ~= nil then programs[name] = body end
end

-- M99 in the main program goes back to its start, for as long as the limits of the run allow; a pass in which no
-- time goes by would repeat for ever.
function run_first()
  if first == nil then return end
  repeat
    local began = core.time()
    local ended = first()
    if ended == TO_START and core.time() == began then
      core.stop("M99 leads back to the start of the main program, and nothing moves in between: an endless loop")
    end
  until ended ~= TO_START
end

-- The program of a file beside this one: the one with that number, or the first of the file.
local function load_beside(number)
  local outer = first
  first = nil
  local found = core.load_program(number)
  local body = programs[number] or first
  first = outer
  if not found or body == nil then
    alarm("M98: there is no program O%d, neither in this file nor beside it", number)
  end
  programs[number] = body
  return body
end

local function whole(value, name)
  if type(value) ~= "number" or value % 1 ~= 0 or value < 0 or value > MOST then
    alarm("%s of M98 is a whole number from 0 to %d, not %s", name, MOST, tostring(value))
  end
  return math.tointeger(value)
end

word("M98", function(words)
  if type(words) ~= "table" or words.p == nil then alarm("M98 needs P, the program that it calls") end
  local number = whole(words.p, "P")
  local times = words.l == nil and 1 or whole(words.l, "L")
  local body = programs[number] or load_beside(number)
  if state.depth == MAX_DEPTH then
    alarm("M98 P%d: subprograms are nested more than %d deep", number, MAX_DEPTH)
  end
  state.depth = state.depth + 1
  for _ = 1, times do body() end
  state.depth = state.depth - 1
end)

word("M99", function() return TO_START end)

local function program_end()
  core.finish()
end
word("M2", program_end)
word("M30", program_end)

word("M0", function() core.event("stop") end)
word("M1", function()
  core.event("optional_stop", core.optional_stop and "" or "off: passed over")
end)
