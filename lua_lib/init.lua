-- The controller in Lua: the meaning of each word of a part program. This folder can be copied, changed and
-- passed to gsim-run with --lua-lib. `core` is the C++ side (see README.md in this folder), `env` is what
-- scripts see, and use "name" returns the result of another file.

local words = use "core/words"   -- from here on it is noted which file says what to scripts

for _, list in ipairs(use "files") do
  for _, name in ipairs(list) do use(name) end
end

words.finish()
use("core/hooks", "tell")("begin")

-- The functions that the C++ side calls.
local dialect = use "core/dialect"
local main_process, run_interrupt = use("common/processes", "main_process", "run_interrupt")
local stored_data, permanent_variables = dialect.use("stored_data", "stored_data", "permanent_variables")
return {
  flush = use("core/path", "flush"), main_process = main_process, run_interrupt = run_interrupt, stored_data = stored_data,
  permanent_variables = permanent_variables,
}
