-- A flange: a ring of holes, each a sub-path of its own, then the rim.
-- path2gcode samples/flange.path.lua

local middle = {300, 300, 20}
local holes = 6
local upright = {0, 0, 1}

local function around(radius, angle_deg)
    local angle = math.rad(angle_deg)
    return {middle[1] + radius * math.cos(angle), middle[2] + radius * math.sin(angle), middle[3]}
end

local function circle(name, center, radius, turn_deg)
    local start = {center[1] + radius, center[2], center[3]}
    return path{name = name,
        point{motion = "rapid", position_mm = start, tool_axis = upright, actions = {"waterjet_on"}},
        point{motion = "circular", position_mm = start, center_mm = center, normal = {0, 0, turn_deg}, turn_deg = 360,
              feed_mm_min = 900, actions = {"waterjet_off"}}}
end

local flange = {name = "flange"}
for i = 1, holes do
    flange[i] = circle("hole " .. i, around(80, 360 / holes * i), 8, 1)
end
flange[holes + 1] = circle("rim", middle, 120, -1)
return path(flange)
