#pragma once

namespace gsim::batch {

/// Machine of one axis with closed-form times.
inline constexpr const char* kSlide = R"([machine]
name = "slide"
[program]
dialect = "rs274ngc"
[[axis]]
letter = "X"
kind = "linear"
max_mm = 1000.0
max_speed_mm_s = 100.0
max_acceleration_mm_s2 = 1000.0
direction = "x"
)";

/// A search on it for the best override of the feed of p.ngc.
inline constexpr const char* kOverride = R"(programs = "p.ngc"
machines = ["m.toml"]
[objective]
cycle_time_s = 1
[search]
variants = 60
[[setting]]
key = "option.feed_override_percent"
from = 50
to = 150
)";

}  // namespace gsim::batch
