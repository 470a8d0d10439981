-- The words of a word: a table whose keys are those that programs can write (column `keys` of the dialect's table). A key
-- that the word does not take is a mistake, which would else be passed over. (Plain G0 to G3 look at theirs in C++; the
-- arguments of macros are looked at where they are given to variables.)

local alarm, check_table, printed = use("core/basics", "alarm", "check_table", "printed")

local AXES = "a b c u v w x y z radius angle"

-- These say by themselves what they need in place of a table.
local LOOKS_BY_ITSELF = { G4 = true, G48_1 = true, G48_2 = true, G48_3 = true, G52 = true, G92 = true }

local function parted(text)
  local words, from = {}, 1
  while from <= #text do
    local blank = text:find(" ", from) or #text + 1
    words[#words + 1] = text:sub(from, blank - 1)
    from = blank + 1
  end
  return words
end

-- In a table both ways: keys in their order, and true by key.
local function known_keys(keys)
  if keys:sub(1, 4) == "axes" then keys = AXES .. keys:sub(5) end
  local known = parted(keys)
  for i = 1, #known do known[known[i]] = true end
  return known
end

-- Of several keys that it does not take the first one by its name is told.
local function refuse(name, words, known)
  for key, value in pairs(words) do
    if type(key) == "string" and not known[key] then
      local advice = core.word_advice(key, value, known)
      alarm("word-out-of-place", "'%s' is no word that %s takes%s", key, printed(name), advice)
    end
  end
end

-- The meaning of a word, behind a look at its words.
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
    elseif words ~= nil and not LOOKS_BY_ITSELF[name] then
      check_table(words, printed(name))
    end
    return meaning(words, more)
  end
end
