-- Path of every move from the words to the machine. Between them are filters, such as cutter compensation.
-- Each passes the moves that it permits on to the next one, and may buffer moves until it knows those that
-- follow.

local axes, plane_view, shape = use "core/axes", use "core/plane_view", use "core/motion_modifiers"

local PATH_FILTER_MODIFIER = "a path filter"
local SAME_MM = 1e-9

-- The end of the chain: the machine.
local machine = {}
function machine:rapid(target, place) core.rapid_to(target, place) end
function machine:line(target, feed, kind, place) core.line_to(target, feed, place, kind) end
function machine:arc(plane, ccw, first, second, sweep, target, feed, place)
  core.arc(plane, ccw, first, second, sweep, target, feed, place)
end
function machine:act(f) f() end
function machine:flush() end

local filters = {}   -- first to last
local head = machine
local before_feed_move, after_move   -- called before each programmed feed move and after each move, or nil
local event_filter                 -- turns events into others, or nil
local stop_rule                      -- of the present word, if the controller has a special one for it

local path = {}

local function link()
  local following = machine
  for i = #filters, 1, -1 do
    filters[i].next = following
    following = filters[i]
  end
  head = following
  shape(PATH_FILTER_MODIFIER, head ~= machine)
  if head == machine then core.set_programmed(nil) end
end

-- A filter has rapid, line, arc, act and flush like the machine above. Moves reach the filter with the lowest
-- `rank` first (50 if it has no rank).
local DEFAULT_RANK = 50

function path.add_filter(filter)
  local place = #filters + 1
  while place > 1 and (filters[place - 1].rank or DEFAULT_RANK) > (filter.rank or DEFAULT_RANK) do place = place - 1 end
  table.insert(filters, place, filter)
  link()
end

-- Pending moves of the filter are output first.
function path.remove_filter(filter)
  filter:flush()
  for i = #filters, 1, -1 do
    if filters[i] == filter then table.remove(filters, i) end
  end
  link()
end

local function moved(target)
  if head ~= machine then core.set_programmed(target) end
  if after_move then after_move() end
end

-- The machine is at another position than the program assumes, until the next move corrects it.
local elsewhere = {}
local is_displaced = false

local function end_displacement()
  is_displaced = false
  path.remove_filter(elsewhere)
end

function elsewhere:rapid(...)
  end_displacement()
  self.next:rapid(...)
end

function elsewhere:line(...)
  end_displacement()
  self.next:line(...)
end

-- An arc begins at the position of the program, at least in its plane.
function elsewhere:arc(plane, ccw, first, second, sweep, target, feed, place)
  local start, view = axes.programmed_point(), plane_view.view(plane)
  local from, at = view:at(start), view:at(axes.machine_point())
  end_displacement()
  if math.abs(from[1] - at[1]) > SAME_MM or math.abs(from[2] - at[2]) > SAME_MM then self.next:rapid(start, place) end
  self.next:arc(plane, ccw, first, second, sweep, target, feed, place)
end

function elsewhere:act(f) self.next:act(f) end
function elsewhere:flush() end

-- Continues the program from `point`, in machine coordinates of all axes, while the machine stays at its
-- position.
function path.continue_from(point)
  is_displaced = true
  path.add_filter(elsewhere)
  core.set_programmed(point)
end

function path.is_displaced() return is_displaced end

function path.rapid(target)
  head:rapid(target, head ~= machine and core.place() or nil)
  moved(target)
end

function path.line(target, feed, kind)
  if before_feed_move then before_feed_move(target) end
  if head == machine then
    core.line_to(target, feed, nil, kind)
  else
    head:line(target, feed or core.take_feed(), kind, core.place())
  end
  moved(target)
end

-- Makes a straight feed move that a signal ends, after all pending moves have been output. See core.probe.
function path.probe(target, away, signal)
  path.flush()
  if is_displaced then end_displacement() end
  local found, at_start, point = core.probe(target, nil, nil, away, signal)
  if head ~= machine then core.set_programmed(axes.machine_point()) end
  if after_move then after_move() end
  return found, at_start, point
end

function path.arc(plane, ccw, first, second, sweep, target, feed)
  if before_feed_move then before_feed_move(target) end
  if head == machine then
    core.arc(plane, ccw, first, second, sweep, target, feed)
    if after_move then after_move() end
    return
  end
  head:arc(plane, ccw, first, second, sweep, target, feed or core.take_feed(sweep), core.place())
  moved(target)
end

-- Adds an action between the moves, in their order.
function path.act(f) head:act(f) end

function path.dwell(seconds)
  if head == machine then
    core.dwell(seconds)
  else
    local place = core.place()
    head:act(function() core.dwell(seconds, place) end)
  end
end

-- Events for which the machine does not stop.
local in_passing = {}
for _, kind in ipairs { "message", "print", "debug", "log", "log_open", "log_append", "log_close", "probe_open",
                        "probe_close", "print_open", "print_close", "tool_select", "override" } do
  in_passing[kind] = true
end

-- Returns the time of an event if its word does not set another one. `changed`: false if it switches no
-- state.
local function event_timing(kind, changed)
  if stop_rule == "always" then return "at_rest" end
  if stop_rule == "never" then return "in_passing" end
  if stop_rule == "on-change" then return changed == false and "in_passing" or "at_rest" end
  return in_passing[kind] and "in_passing" or "at_rest"
end

-- Sets f(kind, detail), which returns the kind and the detail that are reported instead of an event's.
function path.set_event_filter(f) event_filter = f end

-- `when` is "at_standstill", "in_passing" (as the next move or dwell begins) or "with_motion" (as the next move begins).
function path.event(kind, detail, when, changed)
  if event_filter then kind, detail = event_filter(kind, detail) end
  when = when or event_timing(kind, changed)
  if head == machine then
    core.event(kind, detail, nil, when)
  else
    local place = core.place()
    head:act(function() core.event(kind, detail, place, when) end)
  end
end

-- Calls meaning(...), for which the controller waits by a special rule.
function path.call_with_stop_rule(rule, meaning, ...)
  local outer = stop_rule
  stop_rule = rule
  if rule == "always" then path.wait() end
  local result = meaning(...)
  stop_rule = outer
  return result
end

-- The controller reads on after all moves so far have been made.
function path.wait() head:act(core.wait) end

-- Does the same, unless the controller waits at the present word only if that changes a state.
function path.wait_for(changed)
  if changed or stop_rule ~= "on-change" then path.wait() end
end

-- Does the same, if the controller has a rule for `name`, which is part of a word's meaning, and waits by it.
function path.wait_at(name)
  if core.stops[name] == "always" then path.wait() end
end

-- End behaviour of the moves that follow: "exact_stop", "exact_path" (without a stop if the path continues
-- straight) or "continuous", within tolerances of the path and of merged lines (mm; 0: controller's default).
local mode, tolerance, merging

local function set_mode()
  local m, t, q = mode, tolerance, merging
  head:act(function() core.set_path_mode(m, t, q) end)
end

function path.set_mode(name, tolerance_mm, merge_tolerance_mm)
  mode, tolerance, merging = name, tolerance_mm or 0, merge_tolerance_mm or 0
  set_mode()
end
path.set_mode("continuous")

-- Calls f() to move in another mode than that of the program.
function path.call_in_mode(name, f)
  head:act(function() core.set_path_mode(name, 0, 0) end)
  f()
  set_mode()
end

-- Warns that a mode without stops has no effect if the machine's controller brings each move to a standstill.
function path.warn_of_stops(name)
  if core.stops_at_each_move then
    core.warn(name .. ": the controller of this machine stops at each move; one that does not is faster "
      .. "([controller] of the machine file)")
  end
end

-- Passes all pending moves of the filters to the machine: it is at the position of the program, as far as
-- they permit it.
function path.flush()
  for _, filter in ipairs(filters) do filter:flush() end
end

function path.is_filtered() return head ~= machine end

-- Sets f(target) to be called before each programmed feed move (constant surface speed); nil: not any more.
function path.before_feed_moves(f)
  before_feed_move = f
  shape("a call before each feed move", f ~= nil)
end

-- Sets f() to be called after each programmed move (modal macro calls); nil: not any more.
function path.after_each_move(f)
  after_move = f
  shape("a call after each move", f ~= nil)
end

return path
