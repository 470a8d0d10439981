-- Robot-neutral moves to poses: mm and degrees, roll about Z, pitch about Y, yaw about X. The feed is F, in
-- mm/min; a joint move is as fast as the joints are. A linear move is a line of the tool in the work frame, a
-- circular one an arc. If only linear axes move the TCP, these are lines and arcs of the axes. Groups of axes
-- move at the same time: MoveLinear{x=, ..., table={c=90}}.

local alarm = use("core/basics", "alarm")
local word = use("core/words", "word")
local axes, compensation, path = use "core/axes", use "common/compensation", use "core/path"

local parts = { x = true, y = true, z = true, roll = true, pitch = true, yaw = true }
local groups = {}
for _, name in ipairs(core.group_names()) do groups[name] = true end

local function refuse(key, name)
  local names = core.group_names()
  local beside = #names > 0 and "; its groups are: " .. table.concat(names, ", ") or ""
  alarm("word-out-of-place", "%s: a pose has x, y, z, roll, pitch and yaw, not '%s'%s", name, tostring(key), beside)
end

local function checked(pose, name)
  if type(pose) ~= "table" then alarm("script", "%s needs a pose: %s{x=, y=, z=, roll=, pitch=, yaw=}", name, name) end
  for key, value in pairs(pose) do
    if not parts[key] and not groups[key] then refuse(key, name) end
    if parts[key] and type(value) ~= "number" then alarm("script", "%s: the value of '%s' is not a number", name, key) end
  end
  return pose
end

-- The path between the poses and the machine must have no filter.
local function begin(name)
  compensation.refuse(name)
  axes.reject_with_tcp_control(name)
  path.flush()
end

word("MoveLinear", function(pose)
  begin("MoveLinear")
  checked(pose, "MoveLinear")
  if core.tip_turns() then core.pose_move(pose) else core.line_to(core.pose_axes(pose)) end
end)

word("MoveJoint", function(pose)
  begin("MoveJoint")
  core.joint_to(core.pose_axes(checked(pose, "MoveJoint")))
end)

-- MoveCircular{via={...}, to={...}}
word("MoveCircular", function(poses)
  if type(poses) ~= "table" or type(poses.via) ~= "table" or type(poses.to) ~= "table" then
    alarm("script", "MoveCircular needs two poses: via={...}, to={...}")
  end
  begin("MoveCircular")
  local via, to = checked(poses.via, "MoveCircular"), checked(poses.to, "MoveCircular")
  for name in pairs(groups) do
    if via[name] then alarm("word-out-of-place", "MoveCircular: the target of the group '%s' must be given in 'to'", name) end
  end
  if core.tip_turns() then
    core.pose_move(to, via)
  else
    core.arc_via(core.pose_axes(via), core.pose_axes(to), 1)
  end
end)
