-- Firmware retraction: G10 retracts the filament, G11 extrudes it again.

local dialect = use "core/dialect"
local word = use("core/words", "word")
local modes, moves, state = dialect.use "modes", dialect.use "moves", dialect.use "state"

local RETRACT_STATE = "_retract_state"

local settings = core.retraction   -- length_mm, speed_mm_s, extra_mm, unretract_speed_mm_s
local is_configured = settings.length_mm > 0
local is_retracted = false

-- Moves E alone by a step. The E position that the program knows does not change.
local function step(length_mm, speed_mm_s)
  modes.save(RETRACT_STATE)
  state.incremental = true
  moves.line({ e = length_mm, f = speed_mm_s * 60 }, "G1")
  modes.restore(RETRACT_STATE)
end

local function is_known(name)
  if not is_configured then
    core.warn(name .. ": this machine has no firmware retraction (retract_length_mm is 0): no effect")
  end
  return is_configured
end

word("G10", function()
  if not is_known("G10") or is_retracted then return end
  step(-settings.length_mm, settings.speed_mm_s)
  is_retracted = true
end)

word("G11", function()
  if not is_known("G11") or not is_retracted then return end
  step(settings.length_mm + settings.extra_mm, settings.unretract_speed_mm_s)
  is_retracted = false
end)

word("SET_RETRACTION", function(words)
  words = words or {}
  settings.length_mm = words.retract_length or settings.length_mm
  settings.speed_mm_s = words.retract_speed or settings.speed_mm_s
  settings.extra_mm = words.unretract_extra_length or settings.extra_mm
  settings.unretract_speed_mm_s = words.unretract_speed or settings.unretract_speed_mm_s
  is_retracted = false
end)
