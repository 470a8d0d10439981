-- G0 and G1 of Klipper, which are identical.

local dialect = use "core/dialect"
local alarm, check_table = use("core/basics", "alarm", "check_table")
local word = use("core/words", "word")
local path, state = use "core/path", dialect.use "state"

local LETTERS = { "x", "y", "z" }

local moves = {}

-- Returns the target of words in program coordinates.
local function move_target(words)
  local target = {}
  for _, letter in ipairs(LETTERS) do
    local value = words[letter]
    if value then
      target[letter] = value + (state.incremental and state.position(letter) or state.origin(letter))
    end
  end
  if words.e then
    local is_valid_step = state.incremental or state.incremental_e
    target.e = words.e * state.e_factor + (is_valid_step and state.position "e" or state.origin "e")
  end
  return target
end

-- Klipper does not know the position of axes whose motors were off.
local function check_motors(target)
  for _, letter in ipairs(LETTERS) do
    if target[letter] and target[letter] ~= state.position(letter) then
      alarm("home", "%s moves, but its motor is switched off: Klipper requires homing", letter:upper())
    end
  end
end

-- Moves straight to machine coordinates, at the active speed.
function moves.to(target)
  state.drop_missing_extruder(target)
  if state.motors_off then check_motors(target) end
  if next(target) ~= nil then path.line(target, state.core_feed()) end
end

function moves.line(words, name)
  check_table(words, name)
  if words == nil then return end
  if words.f then
    if words.f <= 0 then alarm("feed", "F%.10g: a speed must be greater than 0", words.f) end
    state.feed = words.f
  end
  moves.to(move_target(words))
end

for _, name in ipairs { "G0", "G1" } do
  word(name, function(words) moves.line(words, name) end)
end

return moves
