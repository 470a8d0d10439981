-- Robot-neutral moves to poses: mm and degrees, roll about Z, pitch about Y, yaw about X. The feed is F, in
-- mm/min; a joint move is as fast as the joints are.

local parts = { x = true, y = true, z = true, roll = true, pitch = true, yaw = true }

-- The axis values that bring the tool to a pose.
local function axes_of(pose, name)
  if type(pose) ~= "table" then alarm("%s takes a pose: %s{x=, y=, z=, roll=, pitch=, yaw=}", name, name) end
  for key, value in pairs(pose) do
    if not parts[key] then alarm("%s: a pose has x, y, z, roll, pitch and yaw, and no '%s'", name, tostring(key)) end
    if type(value) ~= "number" then alarm("%s: the value of '%s' is no number", name, key) end
  end
  return core.pose_axes(pose)
end

word("MoveLinear", function(pose)
  refuse_with_compensation("MoveLinear")
  path.flush()
  core.line_to(axes_of(pose, "MoveLinear"))
end)

word("MoveJoint", function(pose)
  refuse_with_compensation("MoveJoint")
  path.flush()
  core.joint_to(axes_of(pose, "MoveJoint"))
end)

-- MoveCircular{via={...}, to={...}}
word("MoveCircular", function(poses)
  if type(poses) ~= "table" or type(poses.via) ~= "table" or type(poses.to) ~= "table" then
    alarm("MoveCircular takes two poses: via={...}, to={...}")
  end
  refuse_with_compensation("MoveCircular")
  path.flush()
  core.arc_via(axes_of(poses.via, "MoveCircular"), axes_of(poses.to, "MoveCircular"), 1)
end)
