local _ENV = require "gsim"
rrs.SetCartesianPositionSpeed(50)
rrs.SelectMotionType("linear")
local s, pose = rrs.GetCellFrame("tool")
print(rrs.SelectTargetType("joint"))
print(rrs.GetInverseKinematics(pose, {1,2,3,0,0}))
print(s, rrs.GetForwardKinematics({1,2,3,0,0}))
MoveJoint{1, 2, 3, 0, 0}
