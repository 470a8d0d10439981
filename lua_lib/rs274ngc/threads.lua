-- G33, G33.1 and G76 of RS274/NGC, as LinuxCNC 2.9 executes them.

local dialect = use "core/dialect"
local alarm = use("core/basics", "alarm")
local axes, cycles, motion, ngc_modes, path, spindle, state =
  use "core/axes", use "common/cycles", use "common/motion", dialect.use "modes", use "core/path", use "common/spindle", use "core/state"

local function required_word(words, letter, name)
  local value = cycles.word(words, letter, name)
  if value == nil then alarm("word-missing", "%s needs %s", name, letter:upper()) end
  return value
end

-- Returns the target; `others` lists the other allowed words, each between blanks.
local function axis_words(words, name, others)
  if core.in_machine_frame() then alarm("mode", "%s cannot be used with G53, which requires G0 or G1", name) end
  local target, moved = core.target(words or {}, others)
  if not moved then alarm("word-missing", "%s needs axis words", name) end
  ngc_modes.check_spindle(words, name)
  return target
end

local function reject_rotary(words, name)
  for _, axis in ipairs(axes.list) do
    if axis.rotary and words[axis.letter] ~= nil then
      alarm("word-out-of-place", "%s moves only linear axes; %s cannot be in its block", name, axis.letter:upper())
    end
  end
end

-- With K0, LinuxCNC ignores the spindle: the move uses the active feed.
local function thread(words)
  local target = axis_words(words, "G33", " k spindle ")
  local pitch = required_word(words, "k", "G33")
  if state.spindle == nil then
    alarm("spindle", "G33 moves in step with the spindle, which is stopped (program S and M3 or M4)")
  end
  path.line(target, pitch ~= 0 and spindle.thread_feed(pitch * core.unit_mm(), "G33") or nil, "thread")
end

-- Moves down and, with the spindle reversed, back to the start; I is the speed factor of the return.
local function rigid_tap(words)
  local target = axis_words(words, "G33.1", " i k spindle ")
  reject_rotary(words, "G33.1")
  local pitch = required_word(words, "k", "G33.1") * core.unit_mm()
  local faster = cycles.word(words, "i", "G33.1") or 1
  if not (faster > 0) then alarm("word-value", "I of G33.1 (speed factor) must be greater than 0, not %.10g", faster) end
  local start, forth = axes.programmed_point(), state.spindle
  path.line(target, spindle.thread_feed(pitch, "G33.1"), "thread")
  spindle.turn(forth == "cw" and "ccw" or "cw")
  path.line(start, spindle.thread_feed(pitch * faster, "G33.1"), "thread")
  spindle.turn(forth)
end

local MAX_PASSES = 10000

-- Returns a depth of G76: it is along X, and is interpreted like words of X.
local function depth_word(words, letter)
  return axes.word_in_units("x", required_word(words, letter, "G76")) * core.unit_mm()
end

-- Returns the words of a threading cycle, lengths in mm.
local function thread_words(words)
  local unit = core.unit_mm()
  local t = {
    pitch = required_word(words, "p", "G76") * unit,
    peak = depth_word(words, "i"),                  -- from the drive line to the crest, below 0 for an outside thread
    first_cut = depth_word(words, "j"),
    full_depth = depth_word(words, "k"),
    degression = math.max(cycles.word(words, "r", "G76") or 1, 1),
    slant = math.rad(cycles.word(words, "q", "G76") or 0),
    spring_passes = cycles.repeats(cycles.word(words, "h", "G76") or 0, "H", "G76"),
    taper = (cycles.word(words, "e", "G76") or 0) * unit,
    tapered_ends = cycles.word(words, "l", "G76") or 0,
  }
  if t.peak == 0 then alarm("word-value", "I of G76, from the drive line to the crest of the thread, must not be 0") end
  if t.first_cut <= 0 then
    alarm("word-value", "J of G76, the depth of the first cut, must be greater than 0, not %.10g", words.j)
  end
  if t.full_depth <= t.first_cut then
    alarm("word-value", "K of G76, the full depth, must be greater than J: K%.10g is not greater than J%.10g", words.k, words.j)
  end
  if math.abs(t.slant) >= math.pi / 2 then
    alarm("word-value", "Q of G76 must be an angle below 90 degrees, not %.10g", words.q)
  end
  if t.taper < 0 then alarm("word-value", "E of G76, the length of a taper, must be 0 or more, not %.10g", words.e) end
  if t.tapered_ends % 1 ~= 0 or t.tapered_ends < 0 or t.tapered_ends > 3 then
    alarm("word-value", "L of G76 must be 0 (no taper), 1 (at the entry), 2 (at the exit) or 3 (both), not %.10g", words.l)
  end
  return t
end

-- Returns strokes over X and Z, with the feed for a pitch.
local function lathe_tool(start)
  local y = start.y
  local tool = {}
  function tool.rapid(x, z) path.rapid(core.to_machine { x = x, y = y, z = z }) end
  function tool.cut(x, z, pitch)
    path.line(core.to_machine { x = x, y = y, z = z }, spindle.thread_feed(pitch, "G76"), "thread")
  end
  return tool
end

-- Makes one pass at a depth below the crest; `t` holds the words, and `from` and `to` of the drive line along
-- Z.
local function pass(tool, t, depth)
  local out = t.peak > 0 and -1 or 1              -- from the work to the drive line
  local ahead = t.to > t.from and 1 or -1
  local left = t.full_depth - depth
  local safe = t.drive + out * left               -- X of the drive line of this pass
  local crest = safe + t.peak
  local bottom = crest - out * t.full_depth
  local from = t.from + ahead * depth * math.tan(t.slant)
  local to = t.to - ahead * left * math.tan(t.slant)
  local tapered = t.taper > 0 and t.pitch * math.sqrt(t.taper ^ 2 + t.full_depth ^ 2) / t.taper
  local entry = tapered and t.tapered_ends % 2 == 1
  local exit = tapered and t.tapered_ends >= 2

  tool.rapid(safe, from)
  if entry then
    tool.cut(crest, from, tapered)
    tool.cut(bottom, from + ahead * t.taper, tapered)
  else
    tool.rapid(bottom, from)
  end
  tool.cut(bottom, exit and to - ahead * t.taper or to, t.pitch)
  if exit then tool.cut(crest, to, tapered) end
  tool.rapid(safe, to)
end

local function threading_cycle(words)
  local target = axis_words(words, "G76", " p i j k r q h e l spindle ")
  reject_rotary(words, "G76")
  local t, here = thread_words(words), axes.program_position()
  t.drive, t.from, t.to = here.x, here.z, core.to_program(target).z
  local tool = lathe_tool(here)
  local depth, number = t.first_cut, 1
  -- LinuxCNC measures depths from the drive line, in program units. This matters if rounding decides about a
  -- pass.
  local drive, unit = math.abs(t.peak) / core.unit_mm(), core.unit_mm()
  while drive + depth / unit < drive + t.full_depth / unit do
    if number > MAX_PASSES then
      alarm("word-value", "G76 would need more than %d passes; J is too small or R too large", MAX_PASSES)
    end
    pass(tool, t, depth)
    number = number + 1
    depth = t.first_cut * number ^ (1 / t.degression)
  end
  for _ = 0, t.spring_passes do pass(tool, t, t.full_depth) end
  path.rapid(target)
end

-- These codes are modal, but need their words in each block.
motion.modal_word("G33", thread)
motion.modal_word("G33_1", rigid_tap)
motion.modal_word("G76", threading_cycle)
