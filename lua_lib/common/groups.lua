-- Groups of axes of the machine file ([[group]]): their motion during moves of the tool to poses
-- (common/pose_moves.lua).

local path = use "core/path"

-- group(name): returns a table of functions.
function env.group(name)
  core.group_motion(name)   -- raises an alarm if it does not exist
  local group = {}
  function group.motion() return core.group_motion(name) end
  function group.synchronous() core.set_group_motion(name, "synchronous") end
  function group.coordinated() core.set_group_motion(name, "coordinated") end
  function group.independent() core.set_group_motion(name, "independent") end
  -- Moves independently, during the moves that follow.
  function group.move(axes)
    path.flush()
    core.move_group(name, axes)
  end
  function group.wait()
    path.flush()
    core.wait_for_groups()
  end
  return group
end
