#include "tests/conformance/generator/ngc_generator.h"

#include <gtest/gtest.h>

namespace gsim::conformance::ngc_generator_test {
namespace {

TEST(NgcGenerator, GivesSameProgramForSameSeed) {
    EXPECT_EQ(NgcGenerator(7).program(), NgcGenerator(7).program());
    EXPECT_NE(NgcGenerator(7).program(), NgcGenerator(8).program());
}

TEST(NgcGenerator, WritesEveryComparedFeature) {
    std::string all;
    for (std::size_t seed = 1; seed <= 200; ++seed) all += NgcGenerator(seed).program();
    for (const char* part : {"EXISTS[#1]",
                             "EXISTS[##20]",
                             "EXISTS[#<size>]",
                             "G17",
                             "G18",
                             "G19",
                             "G20",
                             "G90.1",
                             "G91\n",
                             "G93",
                             "G95 F",
                             "G10 L2 ",
                             "G10 L20",
                             "G10 L10",
                             "G10 L1 ",
                             "G52",
                             "G92 ",
                             "G92.3",
                             "G59.3",
                             "G53",
                             "G28",
                             "G30.1",
                             "G43.1",
                             "G43.2",
                             "G38.2",
                             "G33 ",
                             "G33.1",
                             "G76",
                             "G5 ",
                             "G5.1",
                             "G5.2",
                             "G81",
                             "G83",
                             "G73",
                             "@",
                             "G41.1",
                             "G42 D",
                             "G40",
                             "elseif",
                             "repeat",
                             "while",
                             "break",
                             "continue",
                             "call",
                             "return",
                             "M98",
                             "M70",
                             "M73",
                             "M66",
                             "G96",
                             "G64 P",
                             "ATAN[1]/[1]",
                             "#-[-",
                             "MOD",
                             "XOR",
                             "**",
                             "o<0010>",
                             "G#7"}) {
        EXPECT_NE(all.find(part), std::string::npos) << part;
    }
}

}  // namespace
}  // namespace gsim::conformance::ngc_generator_test
