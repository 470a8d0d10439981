-- Operator overrides that the program locks: the moves that follow run as programmed, whatever the overrides
-- are.

local path = use "core/path"

local overrides = {}

local locks = {}   -- by their owner: { feed = true, rapid = true, spindle = false }

local function tell()
  local all = {}
  for _, owner_locks in pairs(locks) do
    for what, is_locked in pairs(owner_locks) do all[what] = all[what] or is_locked end
  end
  path.act(function() core.lock_overrides(all.feed, all.rapid, all.spindle) end)
end

-- Locks for `who` the overrides that are true in `what`, and no others.
function overrides.lock(who, what)
  locks[who] = what
  tell()
end

-- Calls f() with moves as programmed: taps, which must keep step with a spindle.
function overrides.without(f)
  overrides.lock("a tap", { feed = true, rapid = true, spindle = true })
  f()
  overrides.lock("a tap", {})
end

return overrides
