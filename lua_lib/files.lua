-- The files of the library that the dialect loads, in lists; the files that they need are loaded with them.
-- Their order does not matter.

return { use("core/dialect", "files") }
