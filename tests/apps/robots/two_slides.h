#pragma once

#include <string>
#include <vector>

#include <fmt/format.h>

#include "tests/apps/run_program.h"

namespace gsim::apps {

/// A slide along X with a ball of 40 mm at its tool: ramps of 500 mm/s^2.
inline constexpr const char* kSlide = R"([machine]
name = "slide"
inverse = "gantry"
[path]
max_feed_mm_s = 100.0
max_acceleration_mm_s2 = 500.0
[process]
kind = "spindle"
on = ["M3"]
off = ["M5"]
[[axis]]
letter = "X"
kind = "linear"
min_mm = 0.0
max_mm = 600.0
max_speed_mm_s = 150.0
max_acceleration_mm_s2 = 500.0
direction = "x"
[[axis]]
letter = "Y"
kind = "linear"
min_mm = 0.0
max_mm = 400.0
max_speed_mm_s = 150.0
max_acceleration_mm_s2 = 500.0
direction = "y"
[[axis]]
letter = "Z"
kind = "linear"
min_mm = -120.0
max_mm = 0.0
max_speed_mm_s = 60.0
max_acceleration_mm_s2 = 300.0
direction = "z"
[[shape]]
name = "ball"
on = "tool"
shape = { sphere_mm = 40.0 }
)";

class TwoSlides : public Apps {
  protected:
    /// Runs both robots: the right one is 700 mm further on and moves towards the left one, `y_mm` off its
    /// line.
    Ended meet(double y_mm, const std::vector<std::string>& more = {"--json"}) const {
        write("slide.toml", kSlide);
        write("two.toml", fmt::format("[[robot]]\nname = \"left\"\nmachine = \"slide.toml\"\n"
                                      "[[robot]]\nname = \"right\"\nmachine = \"slide.toml\"\n"
                                      "base = {{ x_mm = 700.0, y_mm = {}, roll_deg = 180.0 }}\n",
                                      y_mm));
        write("two.lua",
              "process('l', function() local _ENV = robot 'left' F(6000)\n"
              "  G1{x=600}\n"
              "end)\n"
              "process('r', function() local _ENV = robot 'right' F(3000)\n"
              "  wait(1)\n"
              "  G1{x=300}\n"
              "end)\n");
        std::vector<std::string> arguments{"--robots", "two.toml", "two.lua"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return gsim_run(arguments);
    }
};

}  // namespace gsim::apps
