-- RS274/NGC: comments with an effect. Each becomes an event of the run; no file is written.
--   DEBUG("x is %f, y is %.2f", v[1], parameter("y"))   %f, %.nf and %d take a value, %% is a percent sign

local alarm = use("core/basics", "alarm")
local word = use("core/words", "word")
local path = use "core/path"

local DIGIT_0, DIGIT_9 = ("09"):byte(1, 2)
local UNKNOWN_VALUE_TEXT = "######"   -- for a parameter without a value
local ZERO_LIMIT = 1e-4 -- what is smaller, as LinuxCNC prints it

local plain = { ["%f"] = "%f", ["%d"] = "%.0f", ["%%"] = "%%" }

-- Returns the format that begins at `at`, and the position after it; nil if no format begins there.
local function format_at(text, at)
  local two = text:sub(at, at + 1)
  if plain[two] then return plain[two], at + 2 end
  if two ~= "%." then return nil end
  local digit = text:byte(at + 2)
  if digit == nil or digit < DIGIT_0 or digit > DIGIT_9 or text:sub(at + 3, at + 3) ~= "f" then return nil end
  return text:sub(at, at + 3), at + 4
end

local function display_text(format, value)
  if value == nil then return UNKNOWN_VALUE_TEXT end
  local number = env.number(value)
  local text = format:format(math.abs(number) < ZERO_LIMIT and 0 or number)
  if tonumber(text) == 0 and text:sub(1, 1) == "-" then return text:sub(2) end
  return text
end

local function filled(text, ...)
  local parts, used, at = {}, 0, 1
  while at <= #text do
    local format, after = format_at(text, at)
    if format == "%%" then
      parts[#parts + 1] = "%"
    elseif format then
      used = used + 1
      parts[#parts + 1] = display_text(format, (select(used, ...)))
    else
      parts[#parts + 1] = text:sub(at, at)
    end
    at = after or at + 1
  end
  return table.concat(parts)
end

local function check_text(text, name)
  if type(text) ~= "string" then alarm("script", "%s needs a string", name) end
  return text
end

-- (abort, text): the program ends in an alarm with this text. The text contains the values of its parameters.
word("ABORT", function(text, ...)
  local said = filled(check_text(text, "ABORT"), ...)
  while said:sub(1, 1) == " " do said = said:sub(2) end
  alarm("program-alarm", "%s", said ~= "" and said or "(abort,) needs a text")
end)

-- Comments that run Python inside of LinuxCNC's interpreter, which can have any effect.
for name, display_text in pairs { PY = "(py,)", PYRUN = "(pyrun,)" } do
  word(name, function()
    alarm("code-unsupported",
      "%s runs Python of the controller, which is not supported: remove it, or rewrite it in Lua", display_text)
  end)
end

word("PYRELOAD", function()
  core.warn("(pyreload) has no effect: Python is not supported")
end)

local function message(name, kind, is_visible)
  word(name, function(text, ...)
    check_text(text, name)
    if is_visible == nil or is_visible() then path.event(kind, filled(text, ...)) end
  end)
end

message("DEBUG", "debug", function() return env.v[5599] ~= 0 end)
message("PRINT", "print")
message("LOG", "log")

word("MSG", function(text) path.event("message", check_text(text, "MSG")) end)

-- Defines a word for log files: the events of the report replace them.
local function define_log_word(name, kind)
  word(name, function(file)
    path.event(kind, ("%s (no file is written; the report has what is logged)"):format(check_text(file, name)))
  end)
end
define_log_word("LOGOPEN", "log_open")
define_log_word("LOGAPPEND", "log_append")
define_log_word("PROBEOPEN", "probe_open")
word("LOGCLOSE", function() path.event("log_close") end)
word("PROBECLOSE", function() path.event("probe_close") end)
