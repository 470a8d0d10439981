#include "cam/waterjet/materials_file.h"

#include <filesystem>
#include <random>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sample.h"
#include "tests/support/mangled_text.h"

namespace gsim::waterjet::materials_file_test {
namespace {

using testing::HasSubstr;

// Returns the sample with one part of its text replaced; the part must exist.
std::string error_with(std::string_view fragment, std::string_view other) {
    std::string text(built_in_materials_toml());
    const std::size_t at = text.find(fragment);
    EXPECT_NE(at, std::string::npos) << fragment;
    text.replace(at, fragment.size(), other);
    const auto materials = read_materials(text, "f");
    return materials ? "" : materials.error().message;
}

TEST(MaterialsFile, ReadsSample) {
    const Materials& materials = sample_materials();
    EXPECT_EQ(materials.jet.pressure_mpa, 345);
    EXPECT_FALSE(materials.jet.mixing_tube_mm);
    EXPECT_EQ(materials.lag.contour_error_mm[4], 0.05);
    EXPECT_EQ(materials.prices.currency, "EUR");
    EXPECT_GE(materials.materials.size(), 15U);
    EXPECT_EQ(find_material(materials, "glass").value()->machinability, 596);
}

TEST(MaterialsFile, EveryMaterialCanBePlanned) {
    for (const Material& material : sample_materials().materials)
        EXPECT_GT(sample_plan(material.name, 10, 3).cutting_speed_mm_min, 0) << material.name;
}

TEST(MaterialsFile, ErrorsNameLocationProblemAndCorrection) {
    EXPECT_EQ(error_with("pressure_mpa = 345.0", "presure_mpa = 345.0"),
              "f:6:1: unknown key 'presure_mpa' in [jet]; did you mean 'pressure_mpa'?");
    EXPECT_EQ(error_with("orifice_mm = 0.35\n", "\n"), "f:5:1: [jet] lacks the key 'orifice_mm'");
    EXPECT_EQ(error_with("345.0", "-345.0"), "f:6:16: 'pressure_mpa' must be between 1 and 1000, not -345");
    EXPECT_THAT(error_with("345.0", "nan"), HasSubstr("f:6:16: 'pressure_mpa' must be a number"));
    EXPECT_THAT(error_with("345.0", "\"345\""), HasSubstr("must be a number, not a string"));
    EXPECT_THAT(error_with("quality = 3", "quality = 6"), HasSubstr("'quality' must be between 1 and 5"));
    EXPECT_THAT(error_with("orifice_mm = 0.35", "orifice_mm = 0.35\nmixing_tube_mm = 0.3"),
                HasSubstr("f:8:18: 'mixing_tube_mm' must be greater than 'orifice_mm'"));
    EXPECT_THAT(error_with("[0.4, 0.25", "[0.25"), HasSubstr("must be 5 numbers"));
    EXPECT_THAT(error_with("[0.4, 0.25", "[0.4, -0.25"), HasSubstr("must contain numbers between"));
    EXPECT_THAT(error_with("[kerf]", "[kerb]"), HasSubstr("did you mean 'kerf'?"));
    EXPECT_THAT(error_with("currency = \"EUR\"", "currency = \"\\u0007\""), HasSubstr("control characters"));
}

TEST(MaterialsFile, RejectsInvalidMaterials) {
    EXPECT_THAT(error_with("like = \"mild steel\"", "like = \"mild stel\""),
                HasSubstr("unknown material \"mild stel\"; did you mean \"mild steel\"?"));
    EXPECT_THAT(error_with("like = \"mild steel\"", "like = \"HY-80 steel\""),
                HasSubstr("'like' must name a material with a 'machinability'"));
    EXPECT_THAT(error_with("like = \"mild steel\"", "like = \"mild steel\"\nmachinability = 3.0"),
                HasSubstr("must have one of 'machinability', 'like' and 'measured'; it has 2"));
    EXPECT_THAT(error_with("machinability = 213.0\n", ""), HasSubstr("it has 0"));
    EXPECT_THAT(error_with("name = \"lead\"", "name = \"glass\""), HasSubstr("\"glass\" is given twice"));
    EXPECT_THAT(error_with("name = \"lead\"", "name = \"\""), HasSubstr("'name' must be 1 to 200 bytes"));
}

TEST(MaterialsFile, ChecksMeasuredCut) {
    constexpr std::string_view kCut =
        "measured = { speed_mm_min = 120, thickness_mm = 10, quality = 3, pressure_mpa = 345, "
        "orifice_mm = 0.35, mixing_tube_mm = 1.05, abrasive_g_min = 370, abrasive_factor = 1 }";
    EXPECT_EQ(error_with("machinability = 213.0", kCut), "");
    EXPECT_THAT(error_with("machinability = 213.0", "measured = { speed_mm_min = 120 }"),
                HasSubstr("'measured' lacks the key 'pressure_mpa'"));
    std::string other(kCut);
    other.replace(other.find("345"), 3, "1");
    other.replace(other.find("120"), 3, "1e6");
    EXPECT_THAT(error_with("machinability = 213.0", other),
                HasSubstr("this cut is not possible: 'machinability'"));
    EXPECT_THAT(error_with("machinability = 213.0", "measured = 3"), HasSubstr("must be a table"));
}

TEST(MaterialsFile, ReadsMeasuredCutFromSubtable) {
    const std::string text = fmt::format(
        "{}\n[[material]]\nname = \"our bronze\"\n[material.measured]\nspeed_mm_min = 120\n"
        "thickness_mm = 10\nquality = 3\npressure_mpa = 345\norifice_mm = 0.35\nmixing_tube_mm = 1.05\n"
        "abrasive_g_min = 370\nabrasive_factor = 1\n",
        built_in_materials_toml());
    const Materials materials = read_materials(text, "f").value();
    EXPECT_EQ(materials.materials.back().measured, (MeasuredCut{{345, 0.35, 1.05, 370, 1}, 120, 10, 3}));
}

TEST(MaterialsFile, AcceptsOldKeyNamesAndWarns) {
    std::string text(built_in_materials_toml());
    for (const auto& [name, old_name] :
         {std::pair("min_feed_share", "least_feed_share"), std::pair("\nmin_s", "\nleast_s"),
          std::pair("dynamic_share", "moving_share")})
        text.replace(text.find(name), std::string_view(name).size(), old_name);
    Materials old = read_materials(text, "f").value();
    EXPECT_EQ(old.warnings.size(), 3);
    old.warnings.clear();
    EXPECT_EQ(old, read_materials(built_in_materials_toml(), "f").value());
}

TEST(MaterialsFile, RejectsMissingAndEmptyFiles) {
    EXPECT_FALSE(load_materials("no-such-file.toml"));
    EXPECT_FALSE(read_materials("", "f"));
    EXPECT_FALSE(read_materials(std::string_view("\0", 1), "f"));
}

// For any file content, reading ends with materials that can be planned, or with an error that has a
// position.
TEST(MaterialsFile, CorruptFilesArePlannableOrRejectedWithLocation) {
    std::mt19937 random(5);
    const std::string full(built_in_materials_toml());
    for (int i = 0; i < 2000; ++i) {
        const auto materials = read_materials(test::mangled(random, full), "f");
        if (!materials) {
            EXPECT_TRUE(test::is_located(materials.error().message)) << materials.error().message;
            continue;
        }
        for (const Material& material : materials->materials) {
            CuttingRequest request;
            request.material = material.name;
            request.thickness_mm = 10;
            EXPECT_TRUE(plan_cutting(*materials, request)) << material.name;
        }
    }
}

}  // namespace
}  // namespace gsim::waterjet::materials_file_test
