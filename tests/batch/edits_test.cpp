#include "batch/work/edits.h"

#include <gmock/gmock.h>

#include "machine/file/machine_file.h"

namespace gsim::batch::edits_test {
namespace {

using testing::HasSubstr;

constexpr const char* kMachine = R"([machine]
name = "slide"  # of ours
[[axis]]
letter = "X"
kind = "linear"
max_speed_mm_s = 100.0
[[axis]]
letter = "Y"
kind = "linear"
max_speed_mm_s = 50
[[mass]]
on = "Y"
mass_kg = 12.0
)";

std::string edited(const std::string& key, const nlohmann::json& value, SettingUse use = SettingUse::set) {
    const SettingValue setting{key, value, use};
    const auto text = edit_toml(kMachine, "m.toml", {&setting, 1});
    return text ? *text : "error: " + text.error().message;
}

TEST(EditedToml, FindsElementsByName) {
    EXPECT_THAT(edited("axis.Y.max_speed_mm_s", 75), HasSubstr("max_speed_mm_s = 75\n"));
    EXPECT_THAT(edited("axis.0.max_speed_mm_s", 75), HasSubstr("max_speed_mm_s = 75.0\n"));
    EXPECT_THAT(edited("mass.Y.mass_kg", 9.5), HasSubstr("mass_kg = 9.5\n"));
    EXPECT_THAT(edited("axis.X.max_speed_mm_s", 1.5, SettingUse::factor),
                HasSubstr("max_speed_mm_s = 150.0\n"));
    EXPECT_THAT(edited("axis.X.max_speed_mm_s", 1.5, SettingUse::shift),
                HasSubstr("max_speed_mm_s = 101.5\n"));
    EXPECT_THAT(edited("base.x_mm", 1.5, SettingUse::shift), HasSubstr("x_mm = 1.5\n"))
        << "what is not said is 0";
    EXPECT_THAT(edited("machine.name", "other"), HasSubstr("name = \"other\"  # of ours\n"));
    EXPECT_THAT(edited("controller.model", "ab9"), HasSubstr("[controller]\nmodel = \"ab9\"\n"));
}

TEST(EditedToml, ReportsMissingKeysAndNumbers) {
    EXPECT_THAT(edited("axis.Q.max_speed_mm_s", 75),
                HasSubstr("m.toml: 'axis.Q.max_speed_mm_s': 'Q' does not exist"));
    EXPECT_THAT(edited("axis.7.max_speed_mm_s", 75),
                HasSubstr("'axis.7.max_speed_mm_s': '7' does not exist"));
    EXPECT_THAT(edited("machine.name.of", 75), HasSubstr("'machine.name' is a value without keys"));
    EXPECT_THAT(edited("axis.X.max_jerk_mm_s3", 2, SettingUse::factor),
                HasSubstr("a factor requires a number in the file"));
    EXPECT_THAT(edited("machine.name", 2, SettingUse::shift),
                HasSubstr("an added value requires a number in the file"));
    EXPECT_THAT(edited("machine.name", 2, SettingUse::factor),
                HasSubstr("a factor requires a number in the file"));
}

TEST(EditedData, ChangesValuesOfEntry) {
    const std::string data = "NCFILE\nOFFSET\n54 100 200 0\nENDFILE\n";
    const std::vector<SettingValue> settings{{"OFFSET.54.X", 101.5}, {"OFFSET.54.Z", -3}};
    const auto text = edit_data(data, "d.txt", settings);
    ASSERT_TRUE(text) << text.error().message;
    EXPECT_THAT(*text, HasSubstr("101.5"));
    EXPECT_THAT(*text, HasSubstr("-3"));
    const SettingValue none{"OFFSET.54.Q", 1};
    EXPECT_FALSE(edit_data(data, "d.txt", {&none, 1}));
}

TEST(SettingKey, RejectsInvalidNames) {
    EXPECT_FALSE(find_key_name_error("machine.axis.X.max_mm"));
    EXPECT_FALSE(find_key_name_error("data.OFFSET.54.X"));
    EXPECT_THAT(find_key_name_error("axis.X.max_mm").value().message,
                HasSubstr("must begin with 'machine.'"));
    EXPECT_THAT(find_key_name_error("machine.axis..max_mm").value().message, HasSubstr("empty name"));
    EXPECT_THAT(find_key_name_error("data.OFFSET.54").value().message, HasSubstr("data.SECTION.ID.FIELD"));
    EXPECT_THAT(find_key_name_error("option.a.b").value().message, HasSubstr("is not an option"));
}

}  // namespace
}  // namespace gsim::batch::edits_test
