-- require: the library by its names, else a module of the script's own, a file of Lua in its folder.

-- The ending .inch is for the script that begins the run. In a script that is called later, the active units
-- apply.
local LIBRARY = {
  ["gsim"] = "ab9", ["gsim.inch"] = "ab9", ["gsim.rs274ngc"] = "rs274ngc", ["gsim.rs274ngc.inch"] = "rs274ngc",
  ["gsim.klipper"] = "klipper",
}
local TABLES = { math = true, string = true, table = true, rrs = true }   -- as in plain Lua: require "math"

local loaded = {}     -- what each module has returned
local LOADING = {}    -- value while it runs

-- Returns true if a name begins like the modules of the library.
local function is_library_name(name) return name == "gsim" or name:sub(1, 5) == "gsim." end

local function library(name)
  local dialect = LIBRARY[name]
  if dialect == nil then
    error(("require \"%s\": of the library there are \"gsim\", \"gsim.rs274ngc\" and \"gsim.klipper\" alone"):format(name), 0)
  end
  if dialect ~= core.dialect then
    error(("this run is of the dialect %s, and \"%s\" is another one"):format(core.dialect, name), 0)
  end
  return env
end

function env.require(name)
  if type(name) ~= "string" then error("require takes the name of a module: require \"shapes\"", 0) end
  if is_library_name(name) then return (library(name)) end
  if TABLES[name] then return env[name] end
  if loaded[name] == LOADING then error(("the module \"%s\" requires itself"):format(name), 0) end
  if loaded[name] ~= nil then return loaded[name] end
  local run, reason = core.load_module(name)
  if run == nil then error(("require \"%s\": %s"):format(name, reason), 0) end
  loaded[name] = LOADING
  local value = run()
  loaded[name] = value == nil and true or value
  return loaded[name]
end
