-- The modal state of the control.

return {
  plane = "xy",
  incremental = false,
  unit_mm = core.unit_mm_at_start,   -- mm of one program unit on a linear axis
  frame = "54",         -- 9/Series: work coordinate system in force
  g52 = {}, g92 = {},   -- offsets by axis letter, mm or deg
  polar = false,
  motion = "G0",        -- the modal motion: G0, G1, G2, G3 or CIP
  feed_mode = "minute", -- or "inverse", "revolution"
  feed = 0,             -- RS274/NGC: as F was programmed
  spindle_word = 0,     -- RS274/NGC: as S was programmed
  spindle_rpm = 0,
  path_mode = 64,       -- 9/Series: G61 to G64
  return_level = core.dialect == "rs274ngc" and "r" or "initial",   -- where a cycle leaves the tool: G98 or G99
  arc_absolute = false, -- centres of arcs are points, not vectors from the start
  has_matrix = false,   -- core.set_matrix() is in force: rotation, scaling or mirror image
  tool_offset = {},     -- by axis letter, mm
  depth = 0,            -- of subprograms
}
