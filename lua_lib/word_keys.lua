-- Which keys the table of each word may have, as programs can write them; "axes" stands for all axes. A key that no word
-- takes is a mistake, which would else be passed over. (Plain G0 to G3 look at theirs in C++; the arguments of macros
-- are looked at where they are given to variables.)

local alarm = use("basics", "alarm")

local of_ab9 = {
  ["p x u"] = "G4",
  ["axes l p r"] = "G10",
  ["axes p i j k"] = "G14 G14_1",
  ["axes i j k p"] = "G22",
  ["p"] = "G23 M99",
  ["axes"] = "G27 G28 G29 G31 G48_1 G48_2 G48_3 G50_1 G51_1 G52 G92",
  ["axes p"] = "G30",
  ["axes e f"] = "G33",
  ["d"] = "G41 G42",
  ["h"] = "G43 G43_4 G44",
  ["s"] = "G50",
  ["axes r"] = "G68",
  ["axes k l p q r"] = "G73 G83",
  ["axes k l p r"] = "G74 G82 G84 G86 G88 G89",
  ["axes i j k l p q r"] = "G76 G87",
  ["axes k l r"] = "G81 G85",
  ["p l"] = "M98",
}

local of_rs274ngc = {
  ["p"] = "G4 M50 M52 M53 M62 M63 M64 M65",
  ["axes i j p q"] = "G5",
  ["axes i j"] = "G5_1",
  ["axes p l"] = "G5_2",
  ["axes l p r i j q"] = "G10",
  ["axes"] = "G28 G30 G38_2 G38_3 G38_4 G38_5 G43_1 G52 G92",
  ["axes k spindle"] = "G33",
  ["axes k i spindle"] = "G33_1",
  ["d"] = "G41 G42",
  ["d l"] = "G41_1 G42_1",
  ["h"] = "G43 G43_4",
  ["axes h"] = "G43_2",
  ["p q"] = "G64",
  ["axes l q r"] = "G73 G83",
  ["axes l p r spindle"] = "G74 G84 G86",
  ["axes e h i j k l p q r spindle"] = "G76",
  ["axes l r"] = "G81 G85",
  ["axes l p r"] = "G82 G88 G89",
  ["axes i j k l r"] = "G87",
  ["d spindle"] = "G96",
  ["spindle"] = "G97 M3 M4 M5",
  ["p q r spindle"] = "M19",
  ["p spindle"] = "M51",
  ["q"] = "M61",
  ["e l p q"] = "M66",
  ["e q"] = "M67 M68",
  ["p l"] = "M98",
}

local AXES = "a b c u v w x y z radius angle"

local function parted(text)
  local words, from = {}, 1
  while from <= #text do
    local blank = text:find(" ", from) or #text + 1
    words[#words + 1] = text:sub(from, blank - 1)
    from = blank + 1
  end
  return words
end

local keys_of = {}   -- by the name of a word: its keys in their order
for keys, names in pairs(core.dialect == "rs274ngc" and of_rs274ngc or of_ab9) do
  local list = parted(keys)
  if list[1] == "axes" then
    table.remove(list, 1)
    for i, letter in ipairs(parted(AXES)) do table.insert(list, i, letter) end
  end
  for _, name in ipairs(parted(names)) do keys_of[name] = list end
end

-- G51.1 for the word G51_1.
local function code_name(name)
  local mark = name:find("_")
  return mark and name:sub(1, mark - 1) .. "." .. name:sub(mark + 1) or name
end

-- The meaning of a word, behind a look at the keys of its table.
return function(name, meaning)
  local list = keys_of[name]
  if list == nil then return meaning end
  local known = {}
  for _, key in ipairs(list) do known[key] = true end
  -- Of several the first one by its name is told.
  local function refuse(words)
    for key, value in pairs(words) do
      if type(key) == "string" and not known[key] then
        alarm("word-out-of-place", "'%s' is no word that %s takes%s", key, code_name(name), core.word_advice(key, value, list))
      end
    end
  end
  return function(words, ...)
    if type(words) == "table" then
      for key in unordered(words) do
        if type(key) == "string" and not known[key] then refuse(words) end
      end
    end
    return meaning(words, ...)
  end
end
