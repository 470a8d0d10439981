-- The dialect of the run: its properties, and the files that define its words.
--
-- The folder of a dialect has the file properties.lua, which returns a table of properties by name, and
--   base     the folder from which it inherits each property that it does not set, and all files
--   files    the files that it adds; all in its folder are among them. "x/frames" replaces "ab9/frames" of a base.
-- The folders "core" and "common" are bases, too. Their files cannot be replaced.

local SHARED = { core = true, common = true }

local function folder_of(file) return file:sub(1, file:find("/", 1, true) - 1) end
local function name_of(file) return file:sub(file:find("/", 1, true) + 1) end

-- Returns the properties of a folder and of its bases, the last base at the end.
local function load_chain(folder)
  local chain = {}
  repeat
    local properties = use(folder .. "/properties")
    chain[#chain + 1] = properties
    folder = properties.base
  until folder == nil
  return chain
end

-- Returns the files of a chain, those of the last base first.
local function chain_files(chain)
  local files, position = {}, {}   -- by name: the index of the file of a dialect
  for i = #chain, 1, -1 do
    for _, file in ipairs(chain[i].files) do
      local name = not SHARED[folder_of(file)] and name_of(file)
      local at = position[name] or #files + 1
      files[at] = file
      if name then position[name] = at end
    end
  end
  return files
end

local function chain_property(chain, name)
  for i = 1, #chain do
    if chain[i][name] ~= nil then return chain[i][name] end
  end
  error(("a dialect has no property '%s'"):format(tostring(name)), 0)
end

local dialect = {}

-- Returns the properties of any dialect; a name that it does not have is an error.
function dialect.properties(folder)
  local chain = load_chain(folder)
  return setmetatable({}, { __index = function(_, name) return chain_property(chain, name) end })
end

local active = load_chain(core.dialect)
dialect.files = chain_files(active)

local file_by_name = {}
for _, file in ipairs(dialect.files) do
  if not SHARED[folder_of(file)] then file_by_name[name_of(file)] = file end
end

-- use() for the file of that name in the folder of the dialect, else of its bases, else in common.
function dialect.use(name, ...) return use(file_by_name[name] or "common/" .. name, ...) end

return setmetatable(dialect, { __index = function(_, name) return chain_property(active, name) end })
