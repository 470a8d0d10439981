-- RS274/NGC: G7 and G8 select diameter or radius for X on a lathe. As in LinuxCNC the words X of all codes
-- are then diameters, and so are the depths of G76; centres, R, @ and parameter values of X are not.

local dialect = use "core/dialect"
local word = use("core/words", "word")
local axes, computed, context, named = use "core/axes", dialect.use "computed_codes", dialect.use "modal_state", dialect.use "named_parameters"

local DIAMETER_FACTOR = 0.5

local is_diameter = false

local function mode(name, on)
  word(name, function()
    is_diameter = on
    if axes.is_rotary.x ~= nil then core.set_word_factor("x", on and DIAMETER_FACTOR or 1) end
  end)
  computed.allow("G", name:sub(2))
end
mode("G7", true)
mode("G8", false)

context.save_group("lathe diameter mode", "G8")
named.predefine("_lathe_diameter_mode", function() return is_diameter end)
named.predefine("_lathe_radius_mode", function() return not is_diameter end)
