-- The modal state of the controller.

return {
  frame = "54",         -- 9/Series: work coordinate system in force
  g52 = {}, g92 = {},   -- offsets by axis letter, mm or deg
  polar = false,
  feed = 0,             -- RS274/NGC: as F was programmed
  spindle_word = 0,     -- RS274/NGC: as S was programmed
  path_mode = 64,       -- 9/Series: G61 to G64
  -- position of the tool after a cycle: G98 or G99
  return_level = use("core/dialect", "initial_return_level"),
  tool_offset = {},     -- by axis letter, mm
  depth = 0,            -- of subprograms
}
