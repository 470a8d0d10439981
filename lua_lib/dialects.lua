-- The dialects, each a folder with the file properties.lua.

return { "ab9", "rs274ngc", "klipper" }
