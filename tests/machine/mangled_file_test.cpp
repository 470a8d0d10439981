// For any file content, reading ends with a value or with an error that has a position.
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "base/os/input_file.h"
#include "machine/data/machine_data.h"
#include "machine/file/machine_file.h"
#include "tests/build_files/build_files.h"
#include "tests/support/mangled_text.h"

namespace gsim::machine::mangled_file_test {
namespace {

using Random = std::mt19937;
using test::is_located;
using test::mangled;

TEST(CorruptFile, MachineFileIsReadOrRejectedWithLocation) {
    Random random(1);
    const std::string full(built_in_machine_toml());
    for (int i = 0; i < 3000; ++i) {
        const std::string text = mangled(random, full);
        const auto machine = read_machine(text, "f");
        if (machine) {
            EXPECT_EQ(read_machine(print_machine(*machine), "f").value(), *machine) << text;
        } else {
            EXPECT_TRUE(is_located(machine.error().message)) << machine.error().message << '\n' << text;
        }
    }
}

// With masses, drives and hoses.
TEST(CorruptFile, DynamicsFileIsReadOrRejectedWithLocation) {
    Random random(5);
    const std::string full =
        os::read_text_file(tests::source_path("samples/machines/gantry-dynamics.toml")).value();
    for (int i = 0; i < 3000; ++i) {
        const std::string text = mangled(random, full);
        const auto machine = read_machine(text, "f");
        if (machine) {
            EXPECT_EQ(read_machine(print_machine(*machine), "f").value(), *machine) << text;
        } else {
            EXPECT_TRUE(is_located(machine.error().message)) << machine.error().message << '\n' << text;
        }
    }
}

// Joints by frames on both sides.
TEST(CorruptFile, MillFileIsReadOrRejectedWithLocation) {
    Random random(4);
    const std::string full =
        os::read_text_file(tests::source_path("samples/machines/mill-table-table.toml")).value();
    for (int i = 0; i < 3000; ++i) {
        const std::string text = mangled(random, full);
        const auto machine = read_machine(text, "f");
        if (machine) {
            EXPECT_EQ(read_machine(print_machine(*machine), "f").value(), *machine) << text;
        } else {
            EXPECT_TRUE(is_located(machine.error().message)) << machine.error().message << '\n' << text;
        }
    }
}

// With every key of [controller]. The model is a built-in one: mangled, it names files that do not exist.
TEST(CorruptFile, ControllerTableIsReadOrRejectedWithLocation) {
    Random random(3);
    const std::string full =
        "[machine]\nname = \"m\"\n[controller]\nmodel = \"grbl-1.1\"\nname = \"own.toml\"\n"
        "planner = \"look-ahead\"\nlook_ahead_blocks = 20\ncorner = \"velocity-step\"\n"
        "exact_path_corner = \"stop\"\njunction_deviation_mm = 0.02\nspeed_step_s = 0.01\n"
        "stop_between_rapid_and_feed = true\nlimit_jerk = true\ncentripetal_share = 0.5\n"
        "arc_chord_tolerance_mm = 0.01\ninverse_time_of_chords = false\nmin_feed_mm_min = 2\nsettle_s = "
        "0.1\n"
        "blend_tolerance_mm = 0.1\nblend_tolerance_deg = 1\nposition_gain_1_s = 30\nin_position_mm = 0.01\n"
        "in_position_deg = 0.02\nstandstill_s = 0.2\ndwell_step_s = 0.5\nservo_period_s = 0.001\n"
        "corner_override_percent = 50\ncorner_override_before_mm = 1\ncorner_override_after_mm = 2\n"
        "corner_override_angle_deg = 91\n"
        "[[axis]]\nletter = \"X\"\nkind = \"linear\"\nmax_jerk_mm_s3 = 5\nstep_mm = 0.1\ndh = {}\n";
    ASSERT_TRUE(read_machine(full, "f"));
    for (int i = 0; i < 5000; ++i) {
        const std::string text = mangled(random, full);
        const auto machine = read_machine(text, "f");
        if (machine) {
            EXPECT_EQ(read_machine(print_machine(*machine), "f").value(), *machine) << text;
        } else {
            EXPECT_TRUE(is_located(machine.error().message)) << machine.error().message << '\n' << text;
        }
    }
}

TEST(CorruptFile, RejectsDeepNestingWithLocation) {
    for (const std::string open : {"[", "{a=", "[[", "[{a="}) {
        std::string text = "machine = ";
        for (int i = 0; i < 100000; ++i) text += open;
        const auto machine = read_machine(text, "f");
        ASSERT_FALSE(machine);
        EXPECT_TRUE(is_located(machine.error().message)) << machine.error().message;
    }
}

TEST(CorruptFile, MachineDataAreReadOrRejectedWithLocation) {
    Random random(2);
    const std::vector<Axis> axes = read_machine(built_in_machine_toml(), "").value().axes;
    const std::string full =
        "NCFILE\nOFFSET\n54 200.0001 200.0002 200\n59.1 1 2 3 90 -45 # turned\n505 1 -2 +3 90 inch\n"
        "FIXED\n7 1 2 3 Metric\nALIAS\nWaterJetOn M08\nVARIABLE\n100 2.5\nENDFILE\n";
    for (int i = 0; i < 20000; ++i) {
        const std::string text = mangled(random, full);
        const auto data = read_machine_data(text, "f", axes);
        EXPECT_TRUE(data || is_located(data.error().message)) << data.error().message << '\n' << text;
    }
}

}  // namespace
}  // namespace gsim::machine::mangled_file_test
