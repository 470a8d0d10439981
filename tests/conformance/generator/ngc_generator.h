#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "tests/conformance/random_source.h"

namespace gsim::conformance {

/// Writes a random part program in the words of RS274/NGC: lines, arcs, splines, cycles, threads, probes,
/// planes, units, rotations, offsets, tools, cutter compensation, O-words, conditions, EXISTS, named
/// parameters, kept modal states. The same seed gives the same program. What it knows of the program's state
/// keeps out what LinuxCNC would refuse, and what docs/conformance.md lists as different on purpose.
class NgcGenerator {
  public:
    explicit NgcGenerator(std::size_t seed) : random_(seed) {}

    std::string program();

  private:
    enum class Plane { xy, zx, yz };
    enum class Motion { none, straight, other };

    void line(const std::string& text) { text_ += text + "\n"; }
    std::string value(int size);
    std::string axis_words(int size, bool incremental);

    void setup();
    void block();
    // Motion.
    void straight();
    void modal_straight();
    void polar();
    void machine_move();
    void arc();
    void arc_by_radius();
    void full_circle();
    std::string arc_words(bool absolute_centre);
    void spline();
    void nurbs();
    void cycle();
    void more_holes();
    void probe();
    void thread();
    void threading_cycle();
    void dwell();
    // State.
    void feed_mode();
    void units();
    void plane();
    void lathe();
    void distance();
    void system();
    void set_system();
    void set_system_by_position();
    void shift();
    void tool_offset();
    void tool_data();
    void tool_change();
    void home();
    void spindle();
    void switches();
    void path_mode();
    void shared_words();
    void kept_state();
    void computed_code();
    void back_to_known_place();
    void after_wait();
    void change_tool_offset(const std::string& text);
    // Parameters and O-words.
    void setting();
    void comment();
    void condition();
    void loop();
    void call();
    void small_move();
    void definitions();
    void numbered_programs();
    // Cutter compensation.
    void compensation();
    void compensated_path();
    std::string corner_move(bool straight);

    RandomSource random_;
    std::string text_;
    std::string definitions_;
    int label_ = 100;
    Plane plane_ = Plane::xy;
    Motion motion_ =
        Motion::none;  ///< Modal motion; `other` moves are repeated by their own functions alone.
    bool incremental_ = false;
    bool diameters_ = false;  ///< G7: words X are twice the radius.
    bool rotated_ = false;
    bool shifted_ = false;  ///< A G92 offset may be in force.
    bool tool_offset_ = false;
    bool unsure_ =
        false;  ///< The stand-alone interpreter's canned machine has not moved since its tool offset changed.
    bool inverse_time_ = false;
    bool per_turn_ = false;
    bool spindle_turns_ = false;  ///< The spindle.
};

}  // namespace gsim::conformance
