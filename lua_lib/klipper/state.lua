-- State that Klipper keeps between its commands: modes, the zero point of its coordinates, and its speed.

local alarm = use("core/basics", "alarm")

local INITIAL_FEED_MM_MIN = 25 * 60   -- klippy's speed before any F

local has = {}
for _, axis in ipairs(core.axes()) do has[axis.letter] = true end

local state = {
  incremental = false,     -- G91
  incremental_e = false,   -- M83
  base = {},               -- by letter: the program's zero point, in machine coordinates (G92)
  offset = {},             -- SET_GCODE_OFFSET, of which base has its part
  feed = INITIAL_FEED_MM_MIN,     -- as F was given
  speed_factor = 1,        -- M220
  e_factor = 1,            -- M221
  saved = {},              -- by name
  motors_off = false,      -- M18, M84
}

-- Returns the end of the last move, in machine coordinates.
function state.position(letter)
  if has[letter] then return core.position(letter) end
  return 0
end

-- Removes E from a target if the machine has no extruder. E may be in the target, but cannot move.
function state.drop_missing_extruder(target)
  if target.e == nil or has.e then return end
  if target.e ~= 0 then alarm("axis", "E moves, but this machine has no extruder: no axis E") end
  target.e = nil
end

function state.origin(letter) return state.base[letter] or 0 end

-- The active speed, in the form that the core uses.
local told, cached_feed

function state.core_feed()
  local mm_min = state.feed * state.speed_factor
  if told ~= mm_min then told, cached_feed = mm_min, core.feed_mm_min(mm_min) end
  return cached_feed
end

return state
