-- RS274/NGC: codes whose number is computed, as in G[#<_plane> / 10]: code("G", 17.0). They have no words and
-- take effect before the motion of their block. The axis words of the block then belong to the active modal
-- motion.

local alarm = use("core/basics", "alarm")

local TOLERANCE = 1e-3   -- of a number

local codes = {
  G = " 0 1 2 3 17 18 19 20 21 40 49 54 55 56 57 58 59 59_1 59_2 59_3 61 61_1 64 80 90 90_1 91 91_1 92_1 92_2 92_3 93 94 "
    .. "95 97 98 99 ",
  M = " 3 4 5 7 8 9 48 49 70 71 72 73 ",
}

-- Allows a computed number for a code that another file defines.
local function allow(letter, number) codes[letter] = codes[letter] .. number .. " " end

local FIRST_USER_CODE, LAST_USER_CODE = 100, 199

-- Returns 59.1 as "59_1", or nil.
local function suffix(number)
  local tenths = math.tointeger(math.floor(number * 10 + 0.5))
  if tenths == nil or tenths < 0 or math.abs(number - tenths / 10) > TOLERANCE then return nil end
  return tenths % 10 == 0 and ("%d"):format(tenths // 10) or ("%d_%d"):format(tenths // 10, tenths % 10)
end

function env.code(letter, number)
  local list = codes[letter]
  if list == nil or type(number) ~= "number" then
    alarm("code-unknown", "code() needs G or M, and the number of the code")
  end
  local name = suffix(number)
  local user = letter == "M" and tonumber(name)
  if user and user >= FIRST_USER_CODE and user <= LAST_USER_CODE then return env.M[math.tointeger(user)] {} end
  if name == nil or not list:find(" " .. name .. " ", 1, true) then
    alarm("code-unknown",
      "%s%.10g: a computed number is only possible for a code without words that acts before the motion of "
      .. "its block; write the number directly", letter, number)
  end
  env[letter .. name]()
end

return { allow = allow }
