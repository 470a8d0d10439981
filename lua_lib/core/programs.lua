-- Programs, subprograms, and the end of a run.

local alarm, snap_to_integer = use("core/basics", "alarm", "snap_to_integer")
local word = use("core/words", "word")
local calls, dialect, path = use "core/calls", use "core/dialect", use "core/path"

local MAX_NUMBER = 2^31 - 1     -- of a program number, and of repeats
local RESTART_PROGRAM = "M99"   -- return value of a program that ends in M99

local programs = {}
local first
local last    -- the last defined program: its parts, and `following`, the next one in the file

-- program(number or nil, function): defines a program of this file; the first one of the file runs once the
-- file is loaded.
function env.program(name, body)
  local own = { body }
  local function run()
    local parts = own
    repeat
      for _, part in ipairs(parts) do
        local ended = part()
        if ended ~= nil then return (parts == own or ended ~= RESTART_PROGRAM) and ended or nil end
      end
      parts = parts.following
    until parts == nil
  end
  -- The O-word that a program reaches is only a mark then; M99 after it ends the run.
  if last and dialect.programs_continue then last.following = own end
  last = own
  -- If several have one number, the first one after the main program is called (RS274/NGC has such files).
  if name ~= nil and (programs[name] == nil or programs[name] == first) then programs[name] = run end
  first = first or run
end

-- more(function): continues that program, after the definition of a subroutine.
function env.more(body)
  if last == nil then alarm("script", "more() continues a program, but none has started") end
  last[#last + 1] = body
end

-- A main program that leads back to its start, or by its last block to one of its blocks, repeats
-- indefinitely on the machine. Here it makes the requested number of passes.
local passes = 0

local function end_pass(block)
  passes = passes + 1
  core.note_pass(passes, block)
  return passes >= core.passes
end

-- Returns true if the jump back to that block, by which the main program ends, ends its last pass.
function env.last_pass(block)
  core.note_place()
  return end_pass(block)
end

local function run_main_program()
  if first ~= nil then
    repeat
      local ended = first()
      path.flush()
    until ended ~= RESTART_PROGRAM or end_pass()
  end
  path.flush()
end

-- Loads a file next to this one, for a number or a name. Returns true if it exists, and its first program or
-- nil.
local function load_file(name)
  local outer, outer_last = first, last
  first, last = nil, nil
  local load = core.load_program(name)
  if load then load() end
  local body = first
  first, last = outer, outer_last
  return load ~= nil, body
end

-- Returns the program of a file next to this one: the one with that number, or the first of the file.
local function load_adjacent(number)
  local found, body = load_file(number)
  body = programs[number] or body
  programs[number] = found and body or nil
  return programs[number]
end

-- Returns the body of the program with this number, in this file or in one next to it.
local function find_program(number)
  return programs[number] or load_adjacent(number)
    or alarm("program-missing", "program O%d not found, neither in this file nor next to it", number)
end

local function whole(value, name)
  value = snap_to_integer(value)
  if type(value) ~= "number" or value % 1 ~= 0 or value < 0 or value > MAX_NUMBER then
    alarm("word-value", "%s of M98 must be an integer from 0 to %d, not %s", name, MAX_NUMBER, tostring(value))
  end
  return math.tointeger(value)
end

-- run(name): runs the first program of a file next to the script, on this robot. Its end, for example M30,
-- ends only that program.
function env.run(name)
  if type(name) ~= "string" then
    alarm("script", "run needs the name of a part program next to the script: run(\"part.nc\")")
  end
  local found, body = load_file(name)
  if not found then alarm("program-missing", "file '%s' not found next to the script", name) end
  if body == nil then alarm("program-missing", "the file '%s' contains no program", name) end
  local frame = calls.enter(name)
  core.run_to_end(body)
  path.flush()
  calls.leave(frame)
end

-- O1000, in the form of the report: a name is made once, because programs are called hundreds of thousands of
-- times.
local names = {}

local function program_name(number)
  local name = names[number] or ("O%d"):format(number)
  names[number] = name
  return name
end

-- Calls a program by its number: `times` passes. Returns the number of the block at which the caller
-- continues (M99 P), or nil.
local function call_program(number, times)
  local body = find_program(number)
  local frame = calls.enter(program_name(number))
  local block
  for pass = 1, times do
    if pass > 1 then core.repeat_program() end
    local ended = body()
    if type(ended) == "table" then
      block = ended.block
      break
    end
  end
  calls.leave(frame)
  return block
end

-- M98{p=2, l=3}; the translator adds `true` if the caller can continue at any of its blocks.
word("M98", function(words, can_jump)
  if type(words) ~= "table" or words.p == nil then alarm("word-missing", "M98 needs P, the program to call") end
  local block = call_program(whole(words.p, "P"), words.l == nil and 1 or whole(words.l, "L"))
  if block and not can_jump then
    alarm("jump",
      "M99 P%d of the called program continues at N%d of this one, which is only possible if both are in one "
      .. "file", block, block)
  end
  return block
end)

word("M99", function(words)
  if words == nil or words.p == nil then return RESTART_PROGRAM end
  return { block = whole(words.p, "P") }
end)

local function program_end()
  path.flush()
  core.finish()
end
word("M2", program_end)
word("M30", program_end)

word("M0", function() path.event("stop") end)
word("M1", function()
  path.event("optional_stop", core.optional_stop and "" or "off: skipped")
end)

return { run_main_program = run_main_program, load_file = load_file, find_program = find_program, call_program = call_program }
