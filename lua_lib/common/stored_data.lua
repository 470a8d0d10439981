-- The current contents of the controller's tables, for gsim-run --save-machine-data: in the form of
-- core.offsets, core.tools and core.variables.

local copied = use("core/basics", "copied")
local dialect, tools = use "core/dialect", use "common/tools"

local variables = dialect.use "variables"
local systems = dialect.offset_variables and dialect.use "frames"

local function stored_tools()
  local stored = {}
  for number, tool in pairs(tools.by_number) do
    local entry = copied(tool)
    for _, field in ipairs { "length", "diameter" } do entry[field] = tools.geometry(tool, field) end
    entry.z = nil   -- the length is along Z
    if tool.z then entry.length = entry.length + tool.z end
    stored[number] = entry
  end
  return stored
end

local function stored_data()
  return {
    offsets = systems and systems.stored_offsets() or core.offsets,
    tools = stored_tools(),
    variables = variables.stored(systems and systems.is_origin),
  }
end

return { stored_data = stored_data, permanent_variables = variables.permanent }
