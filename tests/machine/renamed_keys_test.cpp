#include "base/toml/renamed_keys.h"

#include <map>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "machine/file/controller_file.h"
#include "machine/file/machine_file.h"

namespace gsim::machine::renamed_keys_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::string_view kAxis =
    "[[axis]]\nletter = \"X\"\nkind = \"linear\"\nmax_speed_mm_s = 100\nmax_acceleration_mm_s2 = 500\n"
    "direction = \"x\"\n";

std::string machine_text(std::string_view controller_lines, std::string_view more = {}) {
    return fmt::format("[machine]\nname = \"m\"\n[controller]\n{}\n{}{}", controller_lines, kAxis, more);
}

struct MachineWithMessages {
    Result<Machine> machine;
    FileMessages messages;
};

MachineWithMessages read(const std::string& text, const os::Files& files = os::disk()) {
    FileMessages messages;
    auto machine = read_machine(text, "m.toml", files, &messages);
    return {std::move(machine), std::move(messages)};
}

TEST(RenamedKeys, AcceptsOldNamesWithWarning) {
    for (const auto& [old_line, line] :
         std::map<std::string, std::string>{{"rest_s = 0.25", "standstill_s = 0.25"},
                                            {"own_ramps = true", "independent_ramps = true"},
                                            {"least_feed_mm_min = 3", "min_feed_mm_min = 3"}}) {
        const auto renamed = read(machine_text(line));
        const auto old = read(machine_text(old_line));
        ASSERT_TRUE(old.machine) << old.machine.error().message;
        ASSERT_TRUE(renamed.machine) << renamed.machine.error().message;
        EXPECT_EQ(*old.machine, *renamed.machine) << old_line;
        EXPECT_NE(*old.machine, *read(machine_text("")).machine) << old_line << " has an effect";
        EXPECT_THAT(renamed.messages.warnings, IsEmpty());
        const std::string name = line.substr(0, line.find(' '));
        EXPECT_THAT(old.messages.warnings,
                    ElementsAre(testing::AllOf(testing::StartsWith("m.toml:4:1: "), HasSubstr(name))));
    }
}

TEST(RenamedKeys, PrintsNewNames) {
    const auto old = read(machine_text("rest_s = 0.25"));
    const std::string printed = print_machine(*old.machine);
    EXPECT_THAT(printed, HasSubstr("standstill_s = 0.25"));
    EXPECT_EQ(printed.find("rest_s"), std::string::npos);
}

TEST(RenamedKeys, RejectsOldAndNewNameTogether) {
    const auto both = read(machine_text("rest_s = 0.25\nstandstill_s = 0.25"));
    ASSERT_FALSE(both.machine);
    EXPECT_THAT(both.machine.error().message, testing::StartsWith("m.toml:4:1: "));
}

TEST(RenamedKeys, ErrorsPointToOldName) {
    EXPECT_THAT(read(machine_text("rest_s = -1")).machine.error().message,
                testing::StartsWith("m.toml:4:10: "));
}

TEST(RenamedKeys, AcceptsOldNamesOfCalibratedParameters) {
    const std::string text = machine_text("standstill_s = 0.25",
                                          "[calibration]\nruns = 2\nleft_percent = 0.5\n[[calibrated]]\nof = "
                                          "\"controller\"\nkey = \"rest_s\"\ncovariance_percent2 = [4]\n");
    const auto old = read(text);
    ASSERT_TRUE(old.machine) << old.machine.error().message;
    EXPECT_EQ(old.machine->calibration->parameters.front().key, "standstill_s");
    EXPECT_EQ(old.machine->calibration->residual_percent, 0.5);
    EXPECT_EQ(old.messages.warnings.size(), 2);
}

TEST(RenamedKeys, OldNamesAreValidOnlyInTheirTable) {
    EXPECT_FALSE(read("[machine]\nname = \"m\"\nrest_s = 1\n" + std::string(kAxis)).machine);
    EXPECT_FALSE(base::renamed_key("[lag]", "rest_s"));
}

TEST(RenamedKeys, ReportsWarningsOfCustomControllerFile) {
    const os::CallbackFiles files{
        [](const std::string&) -> std::optional<std::string> { return "[controller]\nrest_s = 0.5\n"; }};
    const auto machine = read(machine_text("model = \"own.toml\""), files);
    ASSERT_TRUE(machine.machine) << machine.machine.error().message;
    EXPECT_EQ(machine.machine->controller.standstill.dwell_s, 0.5);
    EXPECT_THAT(machine.messages.warnings, ElementsAre(testing::StartsWith("own.toml:2:1: ")));
}

}  // namespace
}  // namespace gsim::machine::renamed_keys_test
