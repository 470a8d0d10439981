-- Paramacros: a program called with arguments, which become its local variables #1 to #33. G65 calls once, G66 after
-- each move, G66.1 for each block with the words of the block as arguments; G67 ends the last of them.

local alarm, check_table = use("core/basics", "alarm", "check_table")
local word, word_id = use("core/words", "word", "id")
local motion, path, programs = use "common/motion", use "core/path", use "core/programs"

local FIRST_LOCAL, LAST_LOCAL = 1, 33
local MAX_LEVELS = 4        -- of macro calls inside each other; the main program is level 0
local MAX_REPEATS = 9999

-- Variable of each letter. I, J and K that occur more than once set #4 to #33 in sets of three.
local variable_by_key = {
  a = 1, b = 2, c = 3, d = 7, e = 8, f = 9, h = 11, i = 4, j = 5, k = 6, m = 13, q = 17, r = 18, s = 19, t = 20,
  u = 21, v = 22, w = 23, x = 24, y = 25, z = 26,
}
local position_in_set = { i = 0, j = 1, k = 2 }
local MAX_SETS = 10

local level = 0

local function put(locals, number, value, letter)
  if value ~= nil and type(value) ~= "number" then
    alarm("script", "the argument %s of a macro call is not a number", letter:upper())
  end
  if locals[number] ~= nil then
    alarm("word-value", "two arguments of the macro call set #%d, the last one by %s; give only one of them", number,
      letter:upper())
  end
  locals[number] = value
end

-- Repeated I, J, K in their order: a set begins if the letter does not come after the one before.
local function assign_sets(locals, pairs_in_order)
  local set, last = 0, math.huge
  for _, pair in ipairs(pairs_in_order) do
    local letter, value = pair[1], pair[2]
    local rank = position_in_set[letter]
    if rank == nil then
      alarm("word-value", "a macro call repeats only I, J and K, not %s", tostring(letter):upper())
    end
    if rank <= last then set = set + 1 end
    last = rank
    if set > MAX_SETS then alarm("word-value", "a macro call accepts at most %d sets of I, J and K", MAX_SETS) end
    put(locals, 3 * set + 1 + rank, value, letter)
  end
end

-- Returns the local variables that the words of a call make.
local function arguments(words, code, skipped)
  local locals = {}
  for key, value in pairs(words) do
    if type(key) == "string" and not skipped[key] then
      local number = variable_by_key[key]
      if number == nil then
        alarm("word-out-of-place", "%s: %s is not an argument; use A to F, H to K, M and Q to Z", code, key:upper())
      end
      put(locals, number, value, key)
    end
  end
  assign_sets(locals, words)
  return locals
end

local function whole(value, code, letter, most)
  local number = type(value) == "number" and math.tointeger(value)
  if not number or number < 0 or number > most then
    alarm("word-value", "%s of %s must be an integer from 0 to %d, not %s", letter, code, most, tostring(value))
  end
  return number
end

local function read_locals()
  local held = {}
  for number = FIRST_LOCAL, LAST_LOCAL do held[number] = rawget(env.v, number) end
  return held
end

local function write_locals(values)
  for number = FIRST_LOCAL, LAST_LOCAL do rawset(env.v, number, values[number]) end
end

-- Runs a program with these local variables. Returns the local variables at its end, and the block at which
-- the caller must continue (M99 P), or nil.
local function run(number, times, locals)
  if level == MAX_LEVELS then
    alarm("nesting", "the macro O%d is called more than %d macro levels deep", number, MAX_LEVELS)
  end
  local outer = read_locals()
  level = level + 1
  write_locals(locals)
  local block = programs.call_program(number, times)
  local left = read_locals()
  write_locals(outer)
  level = level - 1
  return left, block
end

local function check_jump(block, can_jump)
  if block and not can_jump then
    alarm("jump",
      "M99 P%d of the macro requests a jump to N%d of the calling program, which is not possible here", block,
      block)
  end
end

local CALL_WORDS = { p = true, l = true }

local function make_call(words, code)
  check_table(words, code)
  if words == nil or words.p == nil then alarm("word-missing", "%s requires P, the number of the macro", code) end
  return {
    number = whole(words.p, code, "P", 2 ^ 31 - 1),
    times = words.l == nil and 1 or whole(words.l, code, "L", MAX_REPEATS),
    locals = arguments(words, code, CALL_WORDS),
    every_block = code == "G66.1",
  }
end

-- As with M98 the translator adds `true` if the caller can continue at any of its blocks.
word("G65", function(words, can_jump)
  local call = make_call(words, "G65")
  local _, block = run(call.number, call.times, call.locals)
  check_jump(block, can_jump)
  return block
end)

-- The active modal call; `outer` is the one before it, which acts on the moves of this one's macro.
local modal

local activate_modal

-- Runs the macro of the modal call; within it the outer one is active.
local function run_modal(locals)
  local call = modal
  activate_modal(call.outer)
  local left, block = run(call.number, call.times, locals)
  check_jump(block, false)
  activate_modal(call)
  return left
end

-- G66 sets the arguments; from one call to the next the macro keeps the values that it leaves in them.
local function run_after_move()
  modal.locals = run_modal(modal.locals)
end

-- G66.1: while it is active these words gather arguments instead of acting. A block ends with its motion, or
-- when a word of another line comes.
local motion_code = { G0 = 0, G1 = 1, G2 = 2, G3 = 3 }
local gathered, gathered_line

local function run_block_macro()
  if gathered == nil then return end
  local words = gathered
  gathered = nil
  local locals = arguments(words, "G66.1", { g = true, l = true, p = true })
  for number, letter in pairs { [10] = "g", [12] = "l", [16] = "p" } do
    if words[letter] ~= nil then put(locals, number, words[letter], letter) end
  end
  run_modal(locals)
end

local function gather()
  local line = core.place()
  if gathered and gathered_line ~= line then run_block_macro() end
  gathered, gathered_line = gathered or {}, line
  return gathered
end

local collectors = {}
for _, name in ipairs { "F", "S", "T", "D", "H" } do
  local key = name:lower()
  collectors[name] = core.word(word_id(), function(value) gather()[key] = value end)
end
for _, name in ipairs { "G0", "G1", "G2", "G3", "move" } do
  collectors[name] = core.word(word_id(), function(words)
    check_table(words, name)
    local block = gather()
    for key, value in pairs(words or {}) do block[key] = value end
    block.g = motion_code[name]
    if words ~= nil then run_block_macro() end
  end)
end

function activate_modal(call)
  modal = call
  path.after_each_move(call ~= nil and not call.every_block and run_after_move or nil)
  motion.replace_words("modal macro", call ~= nil and call.every_block and collectors or nil)
end

local function define_modal(name, code)
  word(name, function(words)
    run_block_macro()
    local call = make_call(words, code)
    if call.every_block and next(call.locals) then
      alarm("word-out-of-place", "G66.1 accepts no arguments; each following block gives its arguments")
    end
    programs.find_program(call.number)
    call.outer = modal
    activate_modal(call)
  end)
end
define_modal("G66", "G66")
define_modal("G66_1", "G66.1")

word("G67", function()
  run_block_macro()
  if modal ~= nil then activate_modal(modal.outer) end
end)

-- Returns the active modal call, for the system variables: 66, 66.1 or 67.
local function modal_macro_code()
  if modal == nil then return 67 end
  return modal.every_block and 66.1 or 66
end

return { modal_code = modal_macro_code }
