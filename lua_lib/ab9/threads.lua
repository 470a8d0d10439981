-- G33 of the 9/Series: a thread of constant lead. F is the lead, in the unit of the program per turn; E the
-- number of threads per inch. The lead is valid until another one is programmed.

local alarm = use("core/basics", "alarm")
local cycles, motion, overrides, path, spindle = use "common/cycles", use "common/motion", use "common/overrides", use "core/path", use "common/spindle"

local MM_PER_INCH = 25.4

local lead_mm

local function thread(words)
  local target, moved = core.target(words or {}, " e f q ")
  words = words or {}
  local lead, per_inch = cycles.word(words, "f", "G33"), cycles.word(words, "e", "G33")
  if lead ~= nil and per_inch ~= nil then alarm("word-out-of-place", "G33 requires its lead as F or as E, not both") end
  if lead ~= nil then lead_mm = lead * core.unit_mm() end
  if per_inch ~= nil then
    if not (per_inch > 0) then
      alarm("word-value", "E of G33 must be a number of threads per inch greater than 0, not %.10g", per_inch)
    end
    lead_mm = MM_PER_INCH / per_inch
  end
  if not moved then return end
  if lead_mm == nil then
    alarm("word-missing", "G33 requires its lead: F, the length per revolution, or E, the threads per inch")
  end
  local feed = spindle.thread_feed(lead_mm, "G33")
  overrides.without(function() path.line(target, feed, "thread") end)
end

motion.modal_word("G33", thread)
