// The interface for C, as a caller in C sees it.

#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/gsim.h"

namespace gsim::engine::c_test {
namespace {

using testing::HasSubstr;

constexpr const char* kPart = "G0 X100\nG1 X200 F6000\nG3 X200 Y100 I0 J50\nM2\n";

class CInterface : public testing::Test {
  protected:
    CInterface() { set_program(kPart); }
    ~CInterface() override {
        gsim_run_destroy(run_);
        gsim_request_destroy(request_);
    }
    void set_program(const std::string& text) {
        EXPECT_EQ(gsim_request_set_program(request_, text.data(), text.size(), "part.nc"), GSIM_OK);
    }
    std::int32_t open() {
        run_ = gsim_run_open(request_, on_diagnostic, &diagnostics_);
        return gsim_run_status(run_);
    }
    static void on_diagnostic(void* user, const gsim_diagnostic* reported) {
        static_cast<std::vector<std::string>*>(user)->push_back(reported->text);
    }

    gsim_request* request_ = gsim_request_create();
    gsim_run* run_ = nullptr;
    std::vector<std::string> diagnostics_;
};

template <typename Row>
void keep(void* user, const Row* rows, std::size_t count) {
    static_cast<std::vector<Row>*>(user)->insert(static_cast<std::vector<Row>*>(user)->end(), rows,
                                                 rows + count);
}

TEST_F(CInterface, DeliversMovesSamplesAndReport) {
    ASSERT_EQ(open(), GSIM_OK) << gsim_run_error(run_);
    std::vector<gsim_move> moves;
    std::vector<gsim_sample> samples;
    ASSERT_EQ(gsim_run_on_moves(run_, 0, keep<gsim_move>, &moves), GSIM_OK);
    ASSERT_EQ(gsim_run_on_samples(run_, 0, 0.01, keep<gsim_sample>, &samples), GSIM_OK);
    EXPECT_EQ(gsim_run_axis(run_, 0, 0), 'X');
    EXPECT_EQ(gsim_run_axis_is_rotary(run_, 0, 0), 0);
    ASSERT_EQ(gsim_run_go(run_), GSIM_OK);
    EXPECT_EQ(gsim_run_outcome(run_), GSIM_COMPLETED);
    ASSERT_EQ(moves.size(), 3U);
    EXPECT_EQ(moves[2].kind, GSIM_ARC_CCW);
    EXPECT_NEAR(moves[2].sweep_rad, std::acos(-1.0), 1e-9);
    EXPECT_NEAR(moves[2].center_mm[1], 50, 1e-9);
    EXPECT_NEAR(moves[2].axis[2], 1, 1e-12);
    EXPECT_EQ(moves[1].line, 2U);
    EXPECT_STREQ(gsim_run_file(run_, moves[1].file), "part.nc");
    EXPECT_DOUBLE_EQ(samples.back().t_s, gsim_run_cycle_time_s(run_));
    EXPECT_NEAR(samples.back().axes[1], 100, 1e-9);
    EXPECT_THAT(gsim_run_report_json(run_), HasSubstr("\"completed\""));
    EXPECT_EQ(gsim_run_go(run_), GSIM_FAILED) << "a run can be started only once";
}

TEST_F(CInterface, SegmentGivesAxesAndSpeedInCallback) {
    ASSERT_EQ(open(), GSIM_OK);
    double farthest_mm = 0;
    ASSERT_EQ(gsim_run_on_segments(
                  run_, 0,
                  [](void* user, const gsim_segment* segments, std::size_t count) {
                      for (std::size_t i = 0; i < count; ++i) {
                          double axes[GSIM_MAX_AXES];
                          gsim_segment_axes(&segments[i], segments[i].duration_s / 2, axes);
                          auto& farthest = *static_cast<double*>(user);
                          farthest = std::max(farthest, axes[0]);
                          EXPECT_GT(gsim_segment_speed_mm_s(&segments[i], segments[i].duration_s / 2), 0);
                      }
                  },
                  &farthest_mm),
              GSIM_OK);
    ASSERT_EQ(gsim_run_go(run_), GSIM_OK);
    EXPECT_NEAR(farthest_mm, 250, 1e-6) << "in the middle of the half circle";
}

TEST_F(CInterface, RejectsInvalidProgramWithReport) {
    set_program("G1 X\nG0 Y\n");
    EXPECT_EQ(open(), GSIM_REJECTED);
    EXPECT_EQ(diagnostics_.size(), 2U);
    EXPECT_THAT(gsim_run_report_json(run_), HasSubstr(diagnostics_.back()));
    EXPECT_EQ(gsim_run_go(run_), GSIM_FAILED);
}

TEST_F(CInterface, ReadsFilesByCallback) {
    set_program("M98 P7\nM2\n");
    ASSERT_EQ(gsim_request_set_files(
                  request_,
                  [](void*, const char* name, gsim_bytes* bytes) -> std::int32_t {
                      if (std::string(name) != "O0007.nc") return 0;
                      const std::string text = "O7\nG0 X12\nM99\n";
                      return gsim_bytes_append(bytes, text.data(), text.size()) == GSIM_OK ? 1 : 0;
                  },
                  nullptr),
              GSIM_OK);
    ASSERT_EQ(open(), GSIM_OK);
    ASSERT_EQ(gsim_run_go(run_), GSIM_OK);
    EXPECT_EQ(gsim_run_outcome(run_), GSIM_COMPLETED) << gsim_run_report_text(run_);
}

TEST_F(CInterface, RejectsUnknownKeysAndValues) {
    EXPECT_EQ(gsim_request_set_text(request_, "machin", "x"), GSIM_FAILED);
    EXPECT_EQ(gsim_request_set_number(request_, "passes", 0), GSIM_FAILED);
    EXPECT_EQ(gsim_request_set_number(request_, "cpu_s", std::nan("")), GSIM_FAILED);
    EXPECT_EQ(gsim_request_set_number(request_, "cpu_s", 10), GSIM_OK);
    ASSERT_EQ(gsim_request_set_text(request_, "machine", "no-such.toml"), GSIM_OK);
    EXPECT_EQ(open(), GSIM_FAILED);
    EXPECT_THAT(gsim_run_error(run_), HasSubstr("no-such.toml"));
    EXPECT_EQ(gsim_run_robot_count(run_), 0U);
    EXPECT_EQ(gsim_run_axis(run_, 0, 0), 0);
    EXPECT_EQ(gsim_run_on_moves(run_, 3, keep<gsim_move>, nullptr), GSIM_FAILED);
    EXPECT_EQ(gsim_run_variables(run_), nullptr);
}

TEST_F(CInterface, CanBeCancelledFromCallback) {
    std::string program = "F6000\n";
    for (int i = 0; i < 5000; ++i) program += i % 2 == 0 ? "G1 X10\n" : "G1 X0\n";
    set_program(program);
    ASSERT_EQ(open(), GSIM_OK);
    ASSERT_EQ(gsim_run_on_moves(
                  run_, 0,
                  [](void* user, const gsim_move*, std::size_t) {
                      gsim_run_cancel(*static_cast<gsim_run**>(user));
                  },
                  &run_),
              GSIM_OK);
    EXPECT_EQ(gsim_run_go(run_), GSIM_OK);
    EXPECT_EQ(gsim_run_outcome(run_), GSIM_STOPPED);
}

TEST_F(CInterface, TranslatesToLua) {
    std::string lua;
    const auto take = [](void* user, const char* text, std::size_t size) {
        static_cast<std::string*>(user)->append(text, size);
        return std::int32_t{1};
    };
    ASSERT_EQ(gsim_translate(request_, on_diagnostic, &diagnostics_, take, &lua), GSIM_OK);
    EXPECT_THAT(lua, HasSubstr("G1{x=200"));
    set_program("G1 X\n");
    EXPECT_EQ(gsim_translate(request_, on_diagnostic, &diagnostics_, take, &lua), GSIM_REJECTED);
    EXPECT_EQ(diagnostics_.size(), 1U);
    EXPECT_EQ(gsim_api_version(), GSIM_API_VERSION);
}

TEST_F(CInterface, WritesOutputs) {
    ASSERT_EQ(open(), GSIM_OK);
    std::string csv;
    const auto take = [](void* user, const char* text, std::size_t size) {
        static_cast<std::string*>(user)->append(text, size);
        return std::int32_t{1};
    };
    EXPECT_EQ(gsim_run_write(run_, 0, "film", 0.1, take, &csv), GSIM_FAILED);
    EXPECT_STREQ(gsim_run_error(run_),
                 "'film' is not an output; known outputs: moves, trajectory, dxf, path and plot");
    ASSERT_EQ(gsim_run_write(run_, 0, "trajectory", 0.1, take, &csv), GSIM_OK);
    ASSERT_EQ(gsim_run_go(run_), GSIM_OK);
    EXPECT_THAT(csv, HasSubstr("t_s,line,x_mm"));
}

}  // namespace
}  // namespace gsim::engine::c_test
