-- The files of the library that each dialect loads; the files that they need are loaded with them. Their
-- order does not matter.

local klipper = {
  "common/groups", "common/inputs", "klipper/arcs", "klipper/limits", "klipper/modes", "klipper/moves",
  "klipper/retraction", "core/modules", "common/pose_moves", "common/processes", "core/programs", "core/stored_data",
  "common/zones",
}

local both = {
  "common/arcs", "common/comp_words", "common/expressions", "common/feed", "common/frames", "common/groups",
  "common/inputs", "core/modules", "common/motion", "common/pose_moves", "common/points", "common/polar", "common/probe",
  "common/processes", "core/programs", "core/stored_data", "common/switches", "common/times", "common/tools",
  "common/user_codes", "common/zones",
}

local own = {
  ab9 = {
    "ab9/angles", "ab9/corners", "ab9/data", "ab9/expressions", "ab9/frames", "ab9/home", "ab9/macros", "ab9/modal",
    "ab9/modes", "ab9/print", "ab9/ramps", "ab9/transform", "ab9/variables", "ab9/zones", "ab9/cycles", "ab9/threads",
  },
  rs274ngc = {
    "rs274ngc/cycles", "rs274ngc/computed_codes", "rs274ngc/modal_state", "rs274ngc/frames", "rs274ngc/g10", "rs274ngc/home",
    "rs274ngc/io", "rs274ngc/lathe", "rs274ngc/messages", "rs274ngc/modes", "rs274ngc/named_parameters", "rs274ngc/overrides",
    "rs274ngc/polar", "rs274ngc/probe", "rs274ngc/shared_words", "rs274ngc/splines", "rs274ngc/subs", "rs274ngc/variables",
    "rs274ngc/threads",
  },
}

if core.dialect == "klipper" then return { klipper } end   -- words of other dialects have no meaning there
return { both, own[core.dialect] }
