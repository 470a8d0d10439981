// Samples, programs of the golden files and random programs, written for each control from what they do and
// run again.
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <random>

#include <fmt/format.h>

#include "tests/build_files/build_files.h"
#include "tests/lua_lib/roundtrip/roundtrip_generator.h"
#include "tests/lua_lib/roundtrip/roundtrip_text.h"
#include "tests/round_trip/random_modes.h"
#include "tests/round_trip/way_round.h"

namespace gsim::round_trip::programs_test {
namespace {

namespace fs = std::filesystem;

// Programs of each dialect: as many as the variable says, else `few`.
unsigned programs(unsigned few) {
    const char* const expected_value = std::getenv("GSIM_ROUND_TRIP_PROGRAMS");
    return expected_value == nullptr ? few : static_cast<unsigned>(std::stoul(expected_value));
}

class RoundTrip : public apps::Apps {
  protected:
    std::string file(const std::string& name, const std::string& text) const {
        return (folder_ / write(name, text)).string();
    }
    // Expects the same program, or a named error; returns true if it is written for the controller.
    bool expect_same(const WayRound& round, const Way& write_mode,
                     const std::vector<std::string>& options = {}) const {
        const Outcome outcome = round.end(write_mode, options);
        if (outcome.extension == Ending::not_written || outcome.extension == Ending::not_recorded)
            return false;
        EXPECT_EQ(outcome.extension, Ending::same)
            << write_mode.post << ": " << outcome.differences.positions << "\n"
            << outcome.differences.times << "\n"
            << outcome.differences.events << "\n"
            << outcome.message << "\n"
            << round.written();
        return true;
    }
};

TEST_F(RoundTrip, ReproducesSamplesAndGoldenPrograms) {
    int written = 0;
    for (const fs::path& folder :
         {fs::path(tests::source_path("samples")), fs::path(tests::source_path("tests/golden"))}) {
        for (const auto& entry : fs::directory_iterator(folder)) {
            const bool ngc = entry.path().extension() == ".ngc";
            if (!ngc && entry.path().extension() != ".nc") continue;
            SCOPED_TRACE(entry.path().filename().string());
            for (const char* axes : {"XYZ", "XYZABC"}) {
                WayRound round(folder_, axes);
                if (!round.begin(entry.path(), ngc ? "rs274ngc" : "ab9")) continue;
                for (const Way& write_mode : kWays)
                    written += static_cast<int>(expect_same(round, write_mode));
                break;
            }
        }
    }
    EXPECT_GT(written, 20);
}

// The programs of the random comparison with a second evaluator: offsets, rotations, planes, units, dwells,
// calls and variables of both dialects.
TEST_F(RoundTrip, ReproducesRandomProgramsOfBothDialects) {
    int written = 0;
    for (const auto dialect : {roundtrip::Dialect::ab9, roundtrip::Dialect::ngc}) {
        const std::string name = dialect == roundtrip::Dialect::ab9 ? "ab9" : "rs274ngc";
        for (unsigned seed = 1; seed <= programs(12); ++seed) {
            const std::string text = roundtrip::program_text(roundtrip::random_program(dialect, seed), seed);
            SCOPED_TRACE(fmt::format("{} {}\n{}", name, seed, text));
            WayRound round(folder_, "XYZABC");
            if (!round.begin(file("random.nc", text), name)) continue;
            for (const Way& write_mode : kWays) written += static_cast<int>(expect_same(round, write_mode));
            ASSERT_FALSE(HasFailure());
        }
    }
    EXPECT_GT(written, static_cast<int>(5 * programs(12) / 3));
}

// Modes, feeds, speeds, switches, tools, offsets and subprograms, with each method to write offsets.
TEST_F(RoundTrip, ReproducesRandomModes) {
    int written = 0;
    for (unsigned seed = 1; seed <= programs(10); ++seed) {
        for (const std::string dialect : {"ab9", "rs274ngc"}) {
            const std::string text = random_modes(dialect, seed);
            SCOPED_TRACE(text);
            WayRound round(folder_, "XYZ");
            ASSERT_TRUE(round.begin(file("random.nc", text), dialect)) << round.message();
            for (const Way& write_mode : kWays) {
                for (const char* offsets : {"keep", "none"})
                    written += static_cast<int>(expect_same(round, write_mode, {"--offsets", offsets}));
            }
            ASSERT_FALSE(HasFailure());
        }
    }
    EXPECT_GE(written, static_cast<int>(4 * programs(10)));
}

}  // namespace
}  // namespace gsim::round_trip::programs_test
