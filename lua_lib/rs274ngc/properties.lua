-- RS274/NGC as in LinuxCNC 2.9.

return {
  base = "common",
  module = "gsim.rs274ngc",
  files = {
    "rs274ngc/comp", "rs274ngc/comp_words", "rs274ngc/computed_codes", "rs274ngc/cycles", "rs274ngc/frames",
    "rs274ngc/g10", "rs274ngc/home", "rs274ngc/io", "rs274ngc/lathe", "rs274ngc/messages", "rs274ngc/modal_state",
    "rs274ngc/modes", "rs274ngc/named_parameters", "rs274ngc/overrides", "rs274ngc/polar", "rs274ngc/probe",
    "rs274ngc/shared_words", "rs274ngc/splines", "rs274ngc/subs", "rs274ngc/threads", "rs274ngc/tool_offsets",
    "rs274ngc/variables",
  },
  integer_tolerance = 1e-4,
  max_call_depth = 9,
  nesting_alarm = "%s call: subroutines are nested more than %d deep",
  programs_continue = true,
  initial_return_level = "r",
  initial_motion = "none",
  offset_variables = true,
  ignores_missing_axes = true,
  refuses_plane_change = true,
  -- G76 cuts a thread, and is not modal.
  modal_cycles = { "G73", "G74", "G81", "G82", "G83", "G84", "G85", "G86", "G87", "G88", "G89" },
  peck_tolerance_mm = 0,   -- LinuxCNC compares exactly
  tools_by_number = true,
  tool_change_stops_spindle = true,
  names_unselected_tool = true,
  h0_is_spindle_tool = true,
  -- The radii of an arc differ by up to 0.0283 mm (0.00283 in), or 0.1 % of the radius if that is more, up to a
  -- hundred times that. A number of turns within 0.0001 of an integer counts as that integer.
  arc_rules = {
    radii_tolerance_mm = 0.0283, radii_tolerance_inch_mm = 0.00283 * 25.4, radii_tolerance_share = 0.001,
    radii_tolerance_growth = 100, max_radius_shortfall_mm = 0.00127, turns_tolerance = 1e-4,
  },
  switch_times = { M8 = "coolant_on", M9 = "coolant_off" },
  tool_table_kinds = { [1] = true, [10] = true, [11] = true },   -- L of G10
}
