-- What the control holds in its tables as they are now, for gsim-run --save-machine-data: in the form of core.offsets,
-- core.tools and core.variables.

local is_ngc = core.dialect == "rs274ngc"
if is_ngc then ngc.note_start() end   -- behind all that defines the parameters

local function stored_tools()
  local stored = {}
  for number, tool in pairs(tool_table) do
    local entry = copied(tool)
    for _, field in ipairs { "length", "diameter" } do entry[field] = tool_geometry(tool, field) end
    entry.z = nil   -- the length is along Z
    if tool.z then entry.length = entry.length + tool.z end
    stored[number] = entry
  end
  return stored
end

function stored_data()
  return {
    offsets = is_ngc and ngc.stored_offsets() or core.offsets,
    tools = stored_tools(),
    variables = stored_variables(),
  }
end
