-- The files of the library that each dialect has; those that they need come with them. Their order does not matter.

local klipper = {
  "groups", "inputs", "klipper_arcs", "klipper_limits", "klipper_modes", "klipper_moves", "klipper_retraction", "modules",
  "neutral", "processes", "programs", "stored_data", "zones",
}

local both = {
  "arcs", "comp_words", "expressions", "feed", "frames", "groups", "inputs", "modules", "motion", "neutral", "points", "polar",
  "probe", "processes", "programs", "stored_data", "switches", "times", "tools", "user_codes", "zones",
}

local own = {
  ab9 = {
    "ab9_angles", "ab9_corners", "ab9_data", "ab9_expressions", "ab9_frames", "ab9_home", "ab9_macros", "ab9_modal",
    "ab9_modes", "ab9_print", "ab9_ramps", "ab9_transform", "ab9_variables", "ab9_zones", "cycles_ab9", "threads_ab9",
  },
  rs274ngc = {
    "cycles_ngc", "ngc_computed", "ngc_context", "ngc_frames", "ngc_g10", "ngc_home", "ngc_io", "ngc_lathe", "ngc_messages",
    "ngc_modes", "ngc_named", "ngc_overrides", "ngc_polar", "ngc_probe", "ngc_shared", "ngc_splines", "ngc_subs",
    "ngc_variables", "threads_ngc",
  },
}

if core.dialect == "klipper" then return { klipper } end   -- words of the others mean nothing there
return { both, own[core.dialect] }
