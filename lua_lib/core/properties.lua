-- Properties of all dialects, unless they set others.

return {
  files = {
    "common/groups", "common/inputs", "core/modules", "common/pose_moves", "common/processes", "core/programs",
    "common/zones",
  },
  always_mm = false,             -- without a module for scripts in inches
  integer_tolerance = 0,         -- a number as near to an integer counts as that integer
  max_call_depth = 8,
  nesting_alarm = "%s: programs are nested more than %d deep",
  programs_continue = false,     -- a program that reaches the next O-word of its file goes on after it
  initial_return_level = "initial",
}
