-- Robot-neutral moves to poses: mm and degrees, roll about Z, pitch about Y, yaw about X. The feed is F, in
-- mm/min; a joint move is as fast as the joints are.

word("MoveLinear", function(pose)
  core.line_to(core.pose_axes(pose))
end)

word("MoveJoint", function(pose)
  core.joint_to(core.pose_axes(pose))
end)

-- MoveCircular{via={...}, to={...}}
word("MoveCircular", function(poses)
  if type(poses) ~= "table" or type(poses.via) ~= "table" or type(poses.to) ~= "table" then
    alarm("MoveCircular takes two poses: via={...}, to={...}")
  end
  core.arc_via(core.pose_axes(poses.via), core.pose_axes(poses.to), 1)
end)
