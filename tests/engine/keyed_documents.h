#pragma once

namespace gsim::engine {

// Documents with each table in the guides of keys.

inline constexpr const char* kMachine = R"(ignore = []
[machine]
name = "m"
[program]
[path]
[base]
[tool]
[work]
[controller]
[controller.stops]
[controller.overrides]
[process]
kind = "jet"
on = ["M8"]
off = ["M9"]
[checks]
[times]
[[axis]]
letter = "X"
kind = "linear"
direction = "x"
frame = {}
position_gain_1_s = 30.0
[[axis]]
letter = "C"
kind = "rotary"
dh = {}
position_gain_1_s = 30.0
[[group]]
name = "g"
axes = ["C"]
[[shape]]
name = "s"
on = "base"
shape = { sphere_mm = 1.0 }
frame = {}
[dynamics]
[[mass]]
on = "X"
mass_kg = 1.0
[[hose]]
on = "tool"
anchor_mm = [0, 0, 1]
[calibration]
[[calibrated]]
of = "controller"
key = "speed_step_s"
covariance_percent2 = [1.0]
)";

inline constexpr const char* kCell = R"(ignore = []
[cell]
name = "c"
[[frame]]
name = "f"
frame = {}
[[object]]
name = "o"
shape = { sphere_mm = 1.0 }
frame = {}
[[shape]]
name = "s"
on = "base"
shape = { sphere_mm = 1.0 }
frame = {}
)";

inline constexpr const char* kController = "[controller]\n[controller.stops]\n[controller.overrides]\n";

}  // namespace gsim::engine
