#include "studio/engine/compact_message.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>

#include "studio/engine/message.h"
#include "tests/studio/engine/asked.h"

namespace gsim::studio {
namespace {

constexpr const char* kShort = "G21 G90\nG0 X10\nG1 X10 Y20 F6000\nG2 X30 Y20 I10\nM2\n";

/// All that is posted of a run of a program.
std::vector<std::string> messages_of_run(const std::string& text = kShort) {
    engine::Host host;
    host.files = engine::Files::given([&text](const std::string& name) -> std::optional<std::string> {
        if (name == "part.nc") return text;
        return std::nullopt;
    });
    std::vector<std::string> messages;
    handle_request(R"({"do": "run", "program": "part.nc"})", host,
                   [&](const std::string& bytes) { messages.push_back(bytes); });
    return messages;
}

TEST(CompactMessage, ContainsTcpPathAndTimeRange) {
    int segments = 0;
    for (const std::string& message : messages_of_run()) {
        const Frame full = read_frame(message);
        const auto lean_bytes = compact_message(message);
        ASSERT_EQ(lean_bytes.has_value(), full.is() == "segments");
        EXPECT_EQ(first_segment(message).has_value(), full.is() == "segments");
        if (!lean_bytes) continue;
        ++segments;
        EXPECT_EQ(first_segment(*lean_bytes), 0U);
        const Frame compact = read_frame(*lean_bytes);
        EXPECT_EQ(compact.header["count"], 3);
        EXPECT_EQ(compact.header["start_s"], full.column<double>("start_s").front());
        EXPECT_EQ(compact.header["end_s"],
                  full.column<double>("start_s").back() + full.column<double>("duration_s").back());
        EXPECT_EQ(compact.columns.size(), 4U);
        EXPECT_EQ(compact.columns.at("vertex_mm"), full.columns.at("vertex_mm"));
    }
    EXPECT_EQ(segments, 1);
}

/// Returns the only lean message of a run, and the full message that it was made from.
std::pair<Frame, Frame> lean_and_whole(const std::string& text) {
    for (const std::string& message : messages_of_run(text)) {
        if (const auto compact = compact_message(message)) return {read_frame(*compact), read_frame(message)};
    }
    throw std::logic_error("nothing has moved");
}

TEST(CompactMessage, VerticesEncodeSegmentMoveLimitProcessAndSpeed) {
    const auto [compact, full] = lean_and_whole(kShort);
    const auto packed = compact.column<std::uint32_t>("vertex_segment");
    const auto segment = full.column<std::uint32_t>("vertex_segment");
    const auto flags = full.column<std::uint32_t>("flags");
    const auto length_mm = full.column<double>("length_mm");
    const auto duration_s = full.column<double>("duration_s");
    ASSERT_EQ(packed.size(), segment.size());
    ASSERT_GT(packed.size(), 5U) << "of an arc there are many";
    for (std::size_t i = 0; i < packed.size(); ++i) {
        const std::uint32_t of = packed[i] & 0xffffU;
        EXPECT_EQ(of, segment[i]);
        EXPECT_EQ(packed[i] >> 16U & 15U, flags[of] >> 8U & 15U) << "move";
        EXPECT_EQ(packed[i] >> 20U & 15U, flags[of] >> 12U & 15U) << "limit";
        EXPECT_EQ(packed[i] >> 24U & 1U, flags[of] >> 2U & 1U) << "process";
        const double speed_mm_s = std::exp2((static_cast<double>(packed[i] >> 25U) - 17) / 8);
        EXPECT_NEAR(speed_mm_s * duration_s[of] / length_mm[of], 1, 0.045);
    }
}

/// Returns a message of two lines and an arc in three parts that begins after many days.
std::string late_message() {
    constexpr double kLate_s = 1e6;
    Message message("segments");
    message.header().update({{"robot", 0}, {"first", 0}});
    message.add("start_s", std::vector<double>{kLate_s + 0.001, kLate_s + 0.002, kLate_s + 0.004});
    message.add("duration_s", std::vector<double>{0.001, 0.002, 0.003});
    message.add("length_mm", std::vector<double>{1, 1, 1});
    for (const char* name : {"line", "file", "flags"}) message.add(name, std::vector<std::uint32_t>{0, 0, 0});
    message.add("vertex_mm", std::vector<float>(15));
    message.add("vertex_s", std::vector<float>(5, 1e6F));
    message.add("vertex_segment", std::vector<std::uint32_t>{0, 1, 2, 2, 2});
    return message.bytes();
}

TEST(CompactMessage, TimesAreRelativeToMessageStart) {
    const auto lean_bytes = compact_message(late_message());
    ASSERT_TRUE(lean_bytes);
    const auto times_s = read_frame(*lean_bytes).column<float>("vertex_s");
    const std::vector<double> wanted_s{0.001, 0.003, 0.003, 0.003, 0.006};
    ASSERT_EQ(times_s.size(), wanted_s.size());
    for (std::size_t i = 0; i < times_s.size(); ++i) EXPECT_NEAR(times_s[i], wanted_s[i], 1e-9) << i;
}

TEST(CompactMessage, DwellHasNoSpeed) {
    // The very first vertex is the start of a run: a dwell has only that one.
    const auto [compact, full] = lean_and_whole("G21 G90\nG4 P1\nM2\n");
    const auto packed = compact.column<std::uint32_t>("vertex_segment");
    ASSERT_EQ(packed.size(), 1U);
    EXPECT_EQ(packed[0] >> 25U, 0U);
    EXPECT_EQ(packed[0] >> 16U & 15U, 4U) << "dwell";
}

TEST(CompactMessage, EncodesLinesAsRangesWithOneStep) {
    std::string text = "G21 G90 F6000\n";
    for (int i = 1; i <= 5; ++i) text += "G1 X" + std::to_string(i) + "\n";
    text += "\nG1 Y1\n\nG1 Y2\n\nG1 Y3\nM2\n";  // from line 8 on, with empty lines between
    const auto [compact, full] = lean_and_whole(text);
    EXPECT_EQ(compact.column<std::uint32_t>("lines"), (std::vector<std::uint32_t>{0, 0, 2, 1, 5, 0, 8, 2}));
}

TEST(CompactMessage, EncodesLinesOfLoop) {
    const std::string text =
        "G21 G90 F6000\n#1=0\nWHILE[#1LT3]DO1\nG91 G1 X1\nG1 Y1\nG1 X-1\n#1=[#1+1]\nEND1\nM2\n";
    const auto [compact, full] = lean_and_whole(text);
    const auto lines = compact.column<std::uint32_t>("lines");
    const auto line = full.column<std::uint32_t>("line");
    ASSERT_EQ(line.size(), 9U);
    ASSERT_EQ(lines.size() % 4, 0U);
    std::vector<std::uint32_t> reported;
    for (std::size_t i = 0; i < lines.size(); i += 4) {
        const std::size_t end = i + 4 < lines.size() ? lines[i + 4] : line.size();
        for (std::size_t segment = lines[i]; segment < end; ++segment)
            reported.push_back(lines[i + 2] + lines[i + 3] * static_cast<std::uint32_t>(segment - lines[i]));
    }
    EXPECT_EQ(reported, line);
}

TEST(CompactMessage, RejectsInvalidMessage) {
    const std::string message = messages_of_run().at(1);
    EXPECT_THROW(compact_message(""), std::invalid_argument);
    EXPECT_THROW(compact_message(message.substr(0, 20)), std::invalid_argument);
    EXPECT_THROW(compact_message(message.substr(0, message.size() - 100)), std::invalid_argument);
}

}  // namespace
}  // namespace gsim::studio
