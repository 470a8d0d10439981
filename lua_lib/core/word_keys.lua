-- The argument words of a word: a table whose keys are those that programs can write (column `keys` of the
-- dialect's table). A key that the word does not accept is an error, which would otherwise be ignored. (Plain
-- G0 to G3 check theirs in C++; the arguments of macros are checked when they are assigned to variables.)

local alarm, check_table, printed = use("core/basics", "alarm", "check_table", "printed")

local AXES = "a b c u v w x y z radius angle"

-- These words report by themselves which arguments they need instead of a table.
local CHECKS_OWN_WORDS = { G4 = true, G48_1 = true, G48_2 = true, G48_3 = true, G52 = true, G92 = true }

local function split_words(text)
  local words, from = {}, 1
  while from <= #text do
    local blank = text:find(" ", from) or #text + 1
    words[#words + 1] = text:sub(from, blank - 1)
    from = blank + 1
  end
  return words
end

-- Returns a table with the keys in their order, and true by key.
local function known_keys(keys)
  if keys:sub(1, 4) == "axes" then keys = AXES .. keys:sub(5) end
  local known = split_words(keys)
  for i = 1, #known do known[known[i]] = true end
  return known
end

-- Reports only the first by name of several unknown keys.
local function refuse(name, words, known)
  for key, value in pairs(words) do
    if type(key) == "string" and not known[key] then
      local advice = core.word_advice(key, value, known)
      alarm("word-out-of-place", "'%s' is not a word of %s%s", key, printed(name), advice)
    end
  end
end

-- Returns the meaning of a word, called after a check of its argument words.
return function(name, meaning)
  local keys = core.codes.keys[name]
  if keys == nil then return meaning end
  local known   -- made at the first call
  return function(words, more)
    if type(words) == "table" then
      known = known or known_keys(keys)
      for key in unordered(words) do
        if type(key) == "string" and not known[key] then refuse(name, words, known) end
      end
    elseif words ~= nil and not CHECKS_OWN_WORDS[name] then
      check_table(words, printed(name))
    end
    return meaning(words, more)
  end
end
