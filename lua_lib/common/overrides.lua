-- What the program locks of the operator's overrides: the moves that follow go as programmed, whatever they are turned to.

local path = use "core/path"

local overrides = {}

local locks = {}   -- by who has set them: { feed = true, rapid = true, spindle = false }

local function tell()
  local all = {}
  for _, of_one in pairs(locks) do
    for what, is_locked in pairs(of_one) do all[what] = all[what] or is_locked end
  end
  path.act(function() core.lock_overrides(all.feed, all.rapid, all.spindle) end)
end

-- `who` locks those of `what` that are true, and no others.
function overrides.lock(who, what)
  locks[who] = what
  tell()
end

-- f() moves as programmed: taps, which must keep step with a spindle.
function overrides.without(f)
  overrides.lock("a tap", { feed = true, rapid = true, spindle = true })
  f()
  overrides.lock("a tap", {})
end

return overrides
