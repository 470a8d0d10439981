#pragma once

#include <array>
#include <map>
#include <optional>

#include "tests/lua_lib/roundtrip/roundtrip_control.h"

namespace gsim::roundtrip {

/// RS274/NGC as LinuxCNC's manual has it, in a plain form.
class NgcControl : public Control {
  public:
    explicit NgcControl(const std::array<Point, 9>& systems);

    void run(const ReadBlock& block) override;
    /// #5420 on: the program's position.
    std::optional<double> variable(int number) const override;

  protected:
    Space space() const override;
    Point other_offsets() const override;
    double inverse_time_of_arc_s(double) const override { return 60; }

  private:
    struct System {
        Point origin = Point::Zero();
        double turn_deg = 0;
    };
    /// Values that a cycle keeps as long as the same one continues.
    struct Held {
        std::optional<double> r, depth, peck, dwell_s;
    };
    struct Hole {
        double r = 0, bottom = 0, clear = 0;
    };

    static Space turned(double degrees);
    void set_tools(const ReadBlock& block);
    void set_data(const ReadBlock& block);
    void set_g10(const ReadBlock& block);
    void set_origin_by_position(const ReadBlock& block, System& system);
    void set_g92(const ReadBlock& block);
    void move(const ReadBlock& block);
    void drill(const ReadBlock& block);
    Hole read_levels(const ReadBlock& block);
    void strokes(const Hole& hole);
    void to(bool rapid, const Point& program) { go(rapid, to_machine(program)); }
    void to_level(bool rapid, double level);

    std::array<System, 9> systems_;
    Point g92_ = Point::Zero(), stored_g92_ = Point::Zero(), tool_offset_ = Point::Zero();
    std::map<int, Point> tools_;
    int selected_ = 0, loaded_ = 0;
    bool in_series_ = false;
    double initial_ = 0;
    std::string last_cycle_;
    Held sticky_;
};

}  // namespace gsim::roundtrip
