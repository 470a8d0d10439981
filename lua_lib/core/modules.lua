-- require: the library by its names, else a module of the script's own, a file of Lua in its folder.

local dialect = use "core/dialect"

local TABLES = { math = true, string = true, table = true, rrs = true }   -- as in plain Lua: require "math"

local loaded = {}     -- what each module has returned
local LOADING_MARK = {}    -- value while it runs

-- Returns true if a name begins like the modules of the library.
local function is_library_name(name) return name == "gsim" or name:sub(1, 5) == "gsim." end

-- Returns true if a name is the module of a dialect, by its properties. The ending .inch is for the script that
-- begins the run. In a script that is called later, the active units apply.
local function is_module_of(properties, name)
  return name == properties.module or (not properties.always_mm and name == properties.module .. ".inch")
end

local function library(name)
  if is_module_of(dialect, name) then return env end
  local modules = {}
  for i, folder in ipairs(use "dialects") do
    local properties = dialect.properties(folder)
    if is_module_of(properties, name) then
      error(("this run has the dialect %s; \"%s\" is of another dialect"):format(core.dialect, name), 0)
    end
    modules[i] = ("\"%s\""):format(properties.module)
  end
  local last = table.remove(modules)
  error(("require \"%s\": the library has only %s and %s"):format(name, table.concat(modules, ", "), last), 0)
end

function env.require(name)
  if type(name) ~= "string" then error("require needs the name of a module: require \"shapes\"", 0) end
  if is_library_name(name) then return (library(name)) end
  if TABLES[name] then return env[name] end
  if loaded[name] == LOADING_MARK then error(("the module \"%s\" requires itself"):format(name), 0) end
  if loaded[name] ~= nil then return loaded[name] end
  local run, reason = core.load_module(name)
  if run == nil then error(("require \"%s\": %s"):format(name, reason), 0) end
  loaded[name] = LOADING_MARK
  local value = run()
  loaded[name] = value == nil and true or value
  return loaded[name]
end
