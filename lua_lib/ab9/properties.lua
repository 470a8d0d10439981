-- Allen-Bradley 9/Series.

return {
  base = "common",
  module = "gsim",
  files = {
    "ab9/angles", "ab9/comp", "ab9/comp_words", "ab9/corners", "ab9/cycles", "ab9/data", "ab9/expressions", "ab9/frames",
    "ab9/geometry", "ab9/home", "ab9/macros", "ab9/modal", "ab9/modes", "ab9/print", "ab9/ramps", "ab9/system",
    "ab9/threads", "ab9/tool_offsets", "ab9/transform", "ab9/variables", "ab9/zones",
  },
  keeps_offset_off_plane = true,
  arc_rules = { radii_tolerance_mm = 0.05, radii_tolerance_inch_mm = 0.05, max_radius_shortfall_mm = 0.05 },
  switch_times = { M8 = "process_on", M9 = "process_off" },
  tool_table_kinds = { [10] = true, [11] = true, [12] = true, [13] = true },   -- L of G10
}
