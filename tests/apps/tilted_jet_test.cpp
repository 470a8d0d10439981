// Output of autopath for tilted jets and moving pierces, compared with the geometry of the motion that the
// machine drives.

#include <cmath>
#include <sstream>

#include <fmt/format.h>

#include "base/text/json.h"
#include "base/units.h"
#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::leaning_jet_test {

namespace {

using nlohmann::json;

constexpr double kMiddle_mm = 50;
constexpr double kPart_mm = 40;  // radii
constexpr double kHole_mm = 10;
constexpr double kCutHeight_mm = 3;

struct Sample {
    double x_mm, y_mm, z_mm, b_deg, c_deg;

    bool cuts() const { return std::abs(z_mm - kCutHeight_mm) < 1e-6; }
    double leans_deg() const { return std::abs(c_deg); }
    /// Return the tool's axis, which points up; C is the tilt, B turns it about the vertical.
    double axis_x() const { return std::sin(c_deg * kRadPerDeg) * std::cos(b_deg * kRadPerDeg); }
    double axis_y() const { return std::sin(c_deg * kRadPerDeg) * std::sin(b_deg * kRadPerDeg); }
    double axis_z() const { return std::cos(c_deg * kRadPerDeg); }
    /// Return the point at which the jet's middle meets the upper side of the material, from the middle of
    /// the part.
    double top_x_mm() const { return x_mm - kMiddle_mm - z_mm * axis_x() / axis_z(); }
    double top_y_mm() const { return y_mm - kMiddle_mm - z_mm * axis_y() / axis_z(); }
    double top_radius_mm() const { return std::hypot(top_x_mm(), top_y_mm()); }
    /// Leads touch the circles at the top and at the bottom of the drawing.
    bool may_be_on_a_lead() const { return std::abs(top_x_mm()) < 3; }
    /// Returns the component along a circle about the middle: 0 if the tilt has no part along it.
    double along_the_circle() const {
        return (top_x_mm() * axis_y() - top_y_mm() * axis_x()) / top_radius_mm();
    }
    double outwards() const { return (top_x_mm() * axis_x() + top_y_mm() * axis_y()) / top_radius_mm(); }
};

class TiltedJet : public Apps {
  protected:
    /// The driven motion of a ring that is cut out by a jet.
    std::vector<Sample> drive(const std::vector<std::string>& options) const {
        write("ring.svg",
              fmt::format("<svg width='100mm' height='100mm' viewBox='0 0 100 100'>"
                          "<circle cx='50' cy='50' r='{}'/><circle cx='50' cy='50' r='{}'/></svg>",
                          kPart_mm, kHole_mm));
        std::vector<std::string> arguments{"ring.svg", "-o", "ring.path.json"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Ended outcome = run_program(tests::program_path("autopath"), arguments, folder_);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        const Ended written = run_program(tests::program_path("path2gcode"),
                                          {"--machine", "af5", "ring.path.json", "-o", "ring.nc"}, folder_);
        EXPECT_EQ(written.status, 0) << written.err;
        const Ended driven =
            gsim_run({"--machine", "af5", "ring.nc", "--trajectory", "ring.csv", "--step", "0.05"});
        EXPECT_EQ(driven.status, 0) << driven.err;
        return samples(read("ring.csv"));
    }

  private:
    static std::vector<Sample> samples(const std::string& csv) {
        std::vector<Sample> all;
        std::istringstream lines(csv);
        std::string line;
        std::getline(lines, line);
        EXPECT_EQ(line, "t_s,line,x_mm,y_mm,z_mm,b_deg,c_deg,speed_mm_s");
        while (std::getline(lines, line)) {
            std::vector<double> values;
            std::istringstream cells(line);
            for (std::string cell; std::getline(cells, cell, ',');) values.push_back(std::stod(cell));
            all.push_back({values.at(2), values.at(3), values.at(4), values.at(5), values.at(6)});
        }
        return all;
    }
};

// The jet's axis must stay on the cone of the bevel: a half circle with correct ends may pass through the
// upright.
TEST_F(TiltedJet, StaysOnConeAlongCircle) {
    constexpr double kKerf_mm = 0.8;
    constexpr double kBevel_deg = 30;
    const double half_kerf_mm = kKerf_mm / 2 / std::cos(kBevel_deg * kRadPerDeg);
    std::size_t on_part = 0;
    std::size_t on_hole = 0;
    for (const Sample& sample : drive({"--speed", "300", "--kerf", "0.8", "--bevel", "30"})) {
        if (!sample.cuts()) continue;
        EXPECT_NEAR(sample.leans_deg(), kBevel_deg, 2e-3);
        const bool part = std::abs(sample.top_radius_mm() - (kPart_mm + half_kerf_mm)) < 3e-3;
        const bool hole = std::abs(sample.top_radius_mm() - (kHole_mm - half_kerf_mm)) < 3e-3;
        if ((!part && !hole) || sample.may_be_on_a_lead()) continue;
        ++(part ? on_part : on_hole);
        EXPECT_NEAR(sample.along_the_circle(), 0, 1e-3);
        EXPECT_GT(part ? sample.outwards() : -sample.outwards(), 0) << "it leans over the waste";
    }
    EXPECT_GT(on_part, 950U) << "251 mm at 5 mm/s";
    EXPECT_GT(on_hole, 200U);
}

// The kerf closes by 0.25 mm u / u1 on each side of 12 mm.
TEST_F(TiltedJet, CompensatesTaper) {
    const double share = 307.87 / 1089.1;  // of the separation speed: ReportsCuttingSpeedOfMaterial
    const double wall_tilt_deg = std::atan(0.25 * share / 12) * kDegPerRad;
    std::size_t on_part = 0;
    for (const Sample& sample :
         drive({"--material", "aluminum", "--thickness", "12", "--taper-compensation"})) {
        if (!sample.cuts()) continue;
        EXPECT_LT(sample.leans_deg(), wall_tilt_deg + 2e-3);
        if (std::abs(sample.top_radius_mm() - (kPart_mm + 1.1025 / 2)) > 3e-3) continue;
        if (sample.may_be_on_a_lead()) continue;
        ++on_part;
        EXPECT_NEAR(sample.leans_deg(), wall_tilt_deg, 2e-3) << "so wide an arc is cut as fast as a line";
        EXPECT_GT(sample.outwards(), 0);
        EXPECT_NEAR(sample.along_the_circle(), 0, 1e-4);
    }
    EXPECT_GT(on_part, 800U);
}

// The jet moves back and forth on the lead, for the time that the material takes.
TEST_F(TiltedJet, DynamicPierceTakesItsTimeOnLeadIn) {
    drive({"--speed", "300", "--kerf", "0.8", "--pierce", "4", "--dynamic-pierce"});
    const json path = text::parse_json<json>(read("ring.path.json"));
    for (std::size_t contour = 1; contour < path["paths"].size(); ++contour) {
        const json& targets = path["paths"][contour]["targets"];
        ASSERT_EQ(targets[1]["actions"][0], "waterjet_on");
        const json& pierce = targets[1]["position_mm"];
        double time_s = 0;
        std::size_t at = 2;
        for (; targets[at]["feed_mm_min"] == targets[2]["feed_mm_min"]; ++at) {
            const json& center = targets[at]["center_mm"];
            const double radius_mm = std::hypot(pierce[0].get<double>() - center[0].get<double>(),
                                                pierce[1].get<double>() - center[1].get<double>());
            const double distance_mm = radius_mm * targets[at]["turn_deg"].get<double>() * kRadPerDeg;
            EXPECT_NEAR(distance_mm, 1.6, 1e-9) << "two kerfs";
            time_s += 60 * distance_mm / targets[at]["feed_mm_min"].get<double>();
            if (at % 2 == 1) {
                EXPECT_EQ(targets[at]["position_mm"], pierce) << "back where it began";
            }
        }
        EXPECT_EQ(at % 2, 0U);
        EXPECT_NEAR(time_s, 4, 1e-9);
    }
}

TEST_F(TiltedJet, RejectsOptionsWithoutMaterial) {
    write("part.svg", "<svg width='9mm' height='9mm' viewBox='0 0 9 9'><rect width='5' height='3'/></svg>");
    const std::vector<std::string> plain{"part.svg", "--speed", "300", "--kerf", "0.8"};
    const auto rejected = [&](const std::string& option, const std::string& reason) {
        std::vector<std::string> arguments = plain;
        arguments.push_back(option);
        const Ended ended = run_program(tests::program_path("autopath"), arguments, folder_);
        EXPECT_EQ(ended.status, 2);
        EXPECT_TRUE(contains(ended.err, reason)) << ended.err;
    };
    rejected("--taper-compensation", "--taper-compensation requires --material");
    rejected("--dynamic-pierce", "--dynamic-pierce requires --material, or its time (--pierce)");
}

}  // namespace

}  // namespace gsim::apps::leaning_jet_test
