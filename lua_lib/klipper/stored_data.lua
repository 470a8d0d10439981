-- The tables of the machine data for gsim-run --save-machine-data: Klipper has none of them and leaves them
-- unchanged.

return {
  stored_data = function() return { offsets = core.offsets, tools = core.tools, variables = core.variables } end,
  permanent_variables = function() return {} end,
}
