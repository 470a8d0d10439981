-- Properties of the dialects with G-code in blocks, unless they set others.

return {
  base = "core",
  files = {
    "common/arcs", "common/comp_words", "common/expressions", "common/feed", "common/frames", "common/motion",
    "common/points", "common/polar", "common/probe", "common/stored_data", "common/switches", "common/times",
    "common/tools", "common/user_codes",
  },
  initial_motion = "G0",             -- the modal motion at the start, or "none"
  offset_variables = false,          -- work offsets are stored in variables
  ignores_missing_axes = false,      -- 0 for an axis that the machine does not have has no effect
  refuses_plane_change = false,      -- while cutter compensation is on, also to the plane in which it is
  keeps_offset_off_plane = false, -- after G40 moves that do not move in the plane stay next to the path
  modal_cycles = { "G73", "G74", "G76", "G81", "G82", "G83", "G84", "G85", "G86", "G87", "G88", "G89" },
  peck_tolerance_mm = 1e-9,          -- a remainder above the bottom of a hole up to this is no peck
  tools_by_number = false,           -- T is a number of the tool table, else a pocket
  tool_change_stops_spindle = false,
  names_unselected_tool = false,     -- M6 without a T before it reports the tool in the spindle
  h0_is_spindle_tool = false,        -- H0 means the same as no H
}
