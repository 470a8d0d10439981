-- RS274/NGC: named parameters #<name> as p.name. A name that begins with _ is global, any other is local to
-- the subroutine; some global parameters belong to the controller and are read-only.

local dialect = use "core/dialect"
local alarm, code_number = use("core/basics", "alarm", "code_number")
local axes, compensation, hooks, modes, parameters =
  use "core/axes", use "common/compensation", use "core/hooks", dialect.use "modal_state", dialect.use "variables"
local state, switches, systems, tools = use "core/state", dialect.use "overrides", dialect.use "frames", use "common/tools"

local predefined = {}   -- functions by name

local UNDERSCORE = ("_"):byte()

local function missing(_, name)
  local value = predefined[name]
  if value == nil then
    alarm("variable",
      "the parameter #<%s> has no value here; set it first (names without _ are local to their subroutine)",
      tostring(name))
  end
  return value() + 0.0
end

local globals = setmetatable({}, { __index = missing })

local scope = {
  __index = globals,
  __newindex = function(locals, name, value)
    if predefined[name] then alarm("variable", "#<%s> is read-only: the controller sets it", name) end
    rawset(name:byte() == UNDERSCORE and globals or locals, name, value)
  end,
}

local function new_scope() return setmetatable({}, scope) end
env.p = new_scope()

-- Each call has its own scope. It returns a value only if it sets one.
hooks.on("call", "named parameters", function(frame)
  frame.names, env.p = env.p, new_scope()
end)
hooks.on("return", "named parameters", function(frame)
  env.p, state.call_value = frame.names, nil
end)

local function defined(name)
  return rawget(env.p, name) ~= nil or rawget(globals, name) ~= nil or predefined[name] ~= nil
end

-- Returns true if a parameter exists: exists("depth") for a named one; exists(5) for #5. A numbered one
-- exists if its number is that of a parameter.
function env.exists(name)
  local found
  if type(name) == "number" then found = parameters.has_number(name) else found = defined(name) end
  return found and 1.0 or 0.0
end

-- For comments: returns the value of a named parameter, or nil if it has none.
function env.parameter(name)
  if defined(name) then return env.p[name] end
end

-- predefine("_line", function() return number or boolean end)
local function predefine(name, value)
  predefined[name] = function()
    local now = value()
    if now == true then return 1 end
    return now or 0
  end
end

predefine("_vmajor", function() return 2.9 end)   -- the LinuxCNC version that defines these words
predefine("_vminor", function() return 0 end)
predefine("_task", function() return false end)
predefine("_remap_level", function() return 0 end)
predefine("_call_level", function() return state.depth end)
predefine("_value", function() return state.call_value end)
predefine("_value_returned", function() return state.call_value ~= nil end)

predefine("_line", function()
  core.note_place()
  return core.place() & 0xffffffff
end)

-- Returns ten times the number of a code by its name: G38_2 and G38.2 are 382.
local function code_x10(name) return math.floor((code_number(name) or 80) * 10 + 0.5) end

predefine("_motion_mode", function() return code_x10(core.motion()) end)
local plane_codes = { xy = 170, zx = 180, yz = 190 }
predefine("_plane", function() return plane_codes[core.plane()] end)
predefine("_coord_system", function() return code_x10("G" .. systems.name(systems.active_system)) end)

predefine("_metric", function() return core.unit_mm() == 1 end)
predefine("_imperial", function() return core.unit_mm() ~= 1 end)
predefine("_absolute", function() return not core.is_incremental() end)
predefine("_incremental", function() return core.is_incremental() end)
predefine("_ijk_absolute_mode", function() return core.has_absolute_arc_centers() end)

predefine("_inverse_time", function() return core.feed_mode() == "inverse" end)
predefine("_units_per_minute", function() return core.feed_mode() == "minute" end)
predefine("_units_per_rev", function() return core.feed_mode() == "revolution" end)
predefine("_feed", function() return state.feed end)
predefine("_rpm", function() return state.spindle_word end)
predefine("_spindle_on", function() return state.spindle ~= nil end)
predefine("_spindle_cw", function() return state.spindle == "cw" end)
predefine("_spindle_rpm_mode", function() return modes.active["spindle speed mode"] ~= "G96" end)
predefine("_spindle_css_mode", function() return modes.active["spindle speed mode"] == "G96" end)
predefine("_mist", function() return state.mist end)
predefine("_flood", function() return state.flood end)

predefine("_ccomp", function() return code_x10((compensation.word or "G40"):sub(1, 3)) end)
predefine("_retract_r_plane", function() return modes.active["return level of cycles"] == "G99" end)
predefine("_retract_old_z", function() return modes.active["return level of cycles"] == "G98" end)
predefine("_speed_override", function() return switches.is_enabled("speed") end)
predefine("_feed_override", function() return switches.is_enabled("feed") end)
predefine("_adaptive_feed", function() return switches.is_enabled("adaptive") end)
predefine("_feed_hold", function() return switches.is_enabled("hold") end)

predefine("_current_tool", function() return tools.loaded() end)
predefine("_selected_tool", function() return tools.selected() end)

-- The table has no separate pockets: each tool is in the pocket with its number, and -1 is none.
predefine("_current_pocket", function() return tools.loaded() end)
predefine("_selected_pocket", function() return tools.selected() > 0 and tools.selected() or -1 end)

predefine("_tool_offset", function()
  for _, length in pairs(state.tool_offset) do
    if length ~= 0 then return true end
  end
  return false
end)

-- Returns the tool position after the moves so far: in coordinates of the program, and in those of the
-- machine.
local function position(letter)
  if axes.is_rotary[letter] == nil then return 0 end
  local point = axes.display_point(compensation.offset_tool_position() or axes.programmed_point())
  return axes.in_program_units(letter, core.to_program(point)[letter])
end

local FIRST_POSITION = 5420
for i, letter in ipairs(parameters.letters) do
  local function here() return position(letter) end
  predefine("_" .. letter, here)
  parameters.compute(FIRST_POSITION + i - 1, function()
    compensation.refuse(("reading #%d"):format(FIRST_POSITION + i - 1))
    return here()
  end)
  predefine("_abs_" .. letter, function()
    if axes.is_rotary[letter] == nil then return 0 end
    return axes.in_program_units(letter, axes.display_point(axes.programmed_point())[letter])
  end)
end

return { predefine = predefine }
