#pragma once

#include <array>
#include <map>
#include <optional>

#include "tests/lua_lib/roundtrip/roundtrip_control.h"

namespace gsim::roundtrip {

/// The 9/Series as docs/language.md has it, in a plain form.
class Ab9Control : public Control {
  public:
    /// `systems`: the stored offsets of G54, G55, ..
    explicit Ab9Control(const std::array<Point, 9>& systems) : systems_(systems) { motion_ = "G0"; }

    void run(const ReadBlock& block) override;
    /// #5001 on: the end of the last block. #5021 on: the machine's position. #5221 on: G54, #5241 on: G55,
    /// ..
    std::optional<double> variable(int number) const override;

  protected:
    Space space() const override;
    Point other_offsets() const override { return offsets(); }
    double inverse_time_of_arc_s(double sweep_rad) const override { return 60 * sweep_rad; }

  private:
    using Corner = Eigen::Vector3d;
    struct Scale {
        Corner factor = Corner::Ones(), centre = Corner::Zero();
    };
    struct Rotation {
        int plane = 0;
        Corner centre = Corner::Zero();
        double angle_deg = 0;
        std::size_t system = 0;
    };
    struct Tool {
        double length_mm = 0, wear_mm = 0;
    };
    struct Series {
        double initial = 0;
        std::optional<double> r, bottom, peck, dwell_s;
        std::string before;  // the modal motion to which G80 leads back
    };

    Point offsets() const;
    bool rotates() const { return rotation_ && rotation_->system == system_; }
    void set_transformations(const ReadBlock& block);
    void set_scale(const ReadBlock& block);
    void set_rotation(const ReadBlock& block);
    void set_tool_length(const ReadBlock& block);
    void set_data(const ReadBlock& block);
    void set_table(const ReadBlock& block);
    void shift_to(const ReadBlock& block);
    void move(const ReadBlock& block);
    ReadBlock without_polar(const ReadBlock& block);
    void drill(const ReadBlock& block);
    void read_levels(const ReadBlock& block);
    void drill_here(const std::string& cycle);
    void peck();
    void to_level(bool rapid, double level);

    std::array<Point, 9> systems_;
    Point external_ = Point::Zero(), local_ = Point::Zero(), shift_ = Point::Zero();
    std::array<std::optional<double>, 3> mirror_;
    std::optional<Scale> scale_;
    std::optional<Rotation> rotation_;
    std::map<int, Tool> tools_;
    int length_sign_ = 0, length_number_ = 0;
    double length_mm_ = 0;
    bool polar_ = false;
    std::array<double, 3> polar_angle_deg_{}, polar_radius_{};
    std::optional<Series> series_;
};

}  // namespace gsim::roundtrip
