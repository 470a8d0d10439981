-- Work coordinate systems and offsets.
-- machine = transform(program value * unit) + frame + G52 + G92 + tool offset

local copied = use("core/basics", "copied")
local word = use("core/words", "word")
local axes, frames, hooks, path, state = use "core/axes", use "common/frames", use "core/hooks", use "core/path", use "core/state"

-- Returns the offset of a work coordinate system by its code, in the form of machine data.
local function work_offset(code, letter)
  local offsets = core.offsets[code]
  return offsets and offsets[letter] or 0
end

local shift = {}   -- of the transform, by letter

-- Passes the sum of all offsets to the C++ side.
local function apply_offsets()
  for _, axis in ipairs(axes.list) do
    local letter = axis.letter
    core.set_offset(letter, work_offset(state.frame, letter) + (state.g52[letter] or 0) + (state.g92[letter] or 0)
      + (state.tool_offset[letter] or 0) + (shift[letter] or 0))
  end
end

-- Sets rotation, scaling and mirror image: p' = m * p + by, before the offsets; m is nine numbers row by row,
-- or nil.
local function set_transform(m, by)
  core.set_matrix(m)
  shift = by or {}
  apply_offsets()
  hooks.tell("transform")
end

-- Offsets of the machine at the start of the run, because G10 changes core.offsets.
local at_start = {}
for code, offset in pairs(core.offsets) do at_start[code] = copied(offset) end

local function report_frame(code)
  local start = at_start[code] or {}
  local moved = false
  for letter, value in pairs(core.offsets[code] or {}) do moved = moved or value ~= (start[letter] or 0) end
  core.select_work_offset(code, start, 0, moved)
end

-- G10 has set a system: the active one is reported again.
local function refresh_frame(code)
  apply_offsets()
  if code == state.frame then path.act(function() report_frame(code) end) end
end

local function select_frame(code)
  return function()
    if state.frame ~= code then path.wait() end   -- even if both systems have the same origin
    state.frame = code
    apply_offsets()
    path.act(function() report_frame(code) end)
    hooks.tell("frame")
  end
end

for code = 54, 59 do word("G" .. code, select_frame(tostring(code))) end
for part = 1, 3 do word("G59_" .. part, select_frame("59." .. part)) end
for code = 505, 599 do word("G" .. code, select_frame(tostring(code))) end

-- G92: the present position of the machine gets the given coordinates.
word("G92", function(words)
  local program = axes.program_position()
  local move = {}
  frames.each_axis(words, "G92", "", function(letter, value) move[letter] = program[letter] - value end)
  local space = {}
  space.x, space.y, space.z = core.direction(move.x, move.y, move.z)
  for letter in pairs(axes.is_rotary) do
    state.g92[letter] = (state.g92[letter] or 0) + (space[letter] or move[letter] or 0)
  end
  apply_offsets()
end)

word("G92_1", function()
  state.g92 = {}
  apply_offsets()
end)

-- G52: the zero point moves by the given distances, measured from the work coordinate system.
word("G52", function(words)
  frames.each_axis(words, "G52", "", function(letter, value) state.g52[letter] = value end)
  apply_offsets()
end)

-- G53: this block moves in machine coordinates, absolute.
word("G53", function()
  axes.reject_with_tcp_control("G53")
  core.machine_frame_once()
end)

apply_offsets()
report_frame(state.frame)

return { work_offset = work_offset, refresh_frame = refresh_frame, apply_offsets = apply_offsets, set_transform = set_transform }
