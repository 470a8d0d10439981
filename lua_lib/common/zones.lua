-- Zones of the machine data with SWITCH=n, for the words of a dialect and for M codes of the user.

local alarm, snap_to_integer = use("core/basics", "alarm", "snap_to_integer")
local path = use "core/path"

-- switch_zone(n, on): the zones with that number are active from here on, or no longer.
function env.switch_zone(number, on)
  number = snap_to_integer(number)
  if type(number) ~= "number" or number % 1 ~= 0 or number < 1 or number > 99 then
    alarm("word-value", "the number that switches zones must be an integer from 1 to 99, not %s",
      tostring(number))
  end
  path.act(function()
    if not core.switch_zones(math.tointeger(number), on) then
      alarm("zone", "no zone has SWITCH=%d; zones are defined in section SECURITY of the machine data", number)
    end
  end)
end
