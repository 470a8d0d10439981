#include "controller/module/rcs_host.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/controller/test_module.h"

namespace gsim::rrs::rcs_host_test {
namespace {

using testing::HasSubstr;

class ModuleLoading : public testing::TestWithParam<HostProcess> {
  protected:
    static std::string load_error(const std::string& name, RcsProcessLimits limits = {}) {
        const auto module = module_at(GetParam(), name, limits);
        return module ? "it was loaded" : module.error().message;
    }
};

INSTANTIATE_TEST_SUITE_P(Places, ModuleLoading, both_places(), place_name);

TEST(RcsHost, LoadsModuleWithIndependentControllers) {
    auto library = RcsLibrary::load(module_path("small_module"), slides());
    ASSERT_TRUE(library.has_value()) << library.error().message;
    EXPECT_EQ((*library)->name(), "small_module.so");
    auto one = RcsModule::create(*library, slides());
    auto other = RcsModule::create(*library, slides());
    library->reset();  // the modules keep what they need
    ASSERT_TRUE(one && other);
    gsim_rcs_target target{};
    EXPECT_EQ(one->call(GSIM_RCS_INITIALIZE, nullptr, nullptr), GSIM_RCS_SUCCESS);
    const gsim_rcs_number speed{100};
    one->call(GSIM_RCS_SET_CARTESIAN_POSITION_SPEED, &speed, nullptr);
    EXPECT_EQ(one->call(GSIM_RCS_SET_NEXT_TARGET, &target, nullptr), GSIM_RCS_SUCCESS);
    EXPECT_EQ(other->call(GSIM_RCS_SET_NEXT_TARGET, &target, nullptr), GSIM_RCS_ZERO_SPEED);
    EXPECT_EQ(one->call(9999, nullptr, nullptr), GSIM_RCS_NOT_SUPPORTED);
}

TEST_P(ModuleLoading, ReportsReasonIfLibraryIsNotModule) {
    EXPECT_THAT(load_error("there_is_none"), HasSubstr("cannot load the controller module there_is_none.so"));
    EXPECT_EQ(load_error("no_module"), "no_module.so is not a controller module: it has no gsim_rcs_version");
    EXPECT_EQ(load_error("other_version"),
              "other_version.so is a controller module of version 3 of the interface; this program supports "
              "version 2");
}

TEST_P(ModuleLoading, ReportsReasonIfModuleCreatesNoController) {
    EXPECT_EQ(load_error("no_machine"),
              "no_machine.so created no controller for this machine: It drives lathes alone.");
    EXPECT_EQ(load_error("no_initialize"), "no_initialize.so does not support the service Initialize");
}

TEST_P(ModuleLoading, ReportsCrashWhileLoading) {
    EXPECT_EQ(load_error("crash_on_load"),
              "the controller module crash_on_load.so crashed (signal 11) while it was loaded");
    EXPECT_EQ(load_error("crash_in_create"),
              "the controller module crash_in_create.so crashed (signal 6) while it was loaded");
    const char* const ended =
        GetParam() == HostProcess::separate_process ? "ended its process (status 0)" : "ended the program";
    for (const std::string name : {"ends_program", "ends_in_create"}) {
        EXPECT_EQ(load_error(name),
                  fmt::format("the controller module {}.so {} while it was loaded", name, ended));
    }
}

TEST_P(ModuleLoading, ReportsTimeoutWhileLoading) {
    for (const char* const name : {"hangs_on_load", "hangs_in_create"}) {
        EXPECT_EQ(load_error(name, {.response_timeout_ms = 200}),
                  fmt::format("the controller module {}.so did not respond within 0.2 s while it was loaded",
                              name));
    }
}

TEST(RcsHost, RejectsInvalidLibraryFile) {
    const std::string folder = testing::TempDir();
    const std::string text = folder + "/rcs_host_test_text.so";
    const std::string empty = folder + "/rcs_host_test_empty.so";
    std::ofstream(text) << "planner = none, although the file is long enough for a header of a library";
    std::ofstream{empty};
    for (const std::string& path : {text, empty, folder}) {
        const auto library = RcsLibrary::load(path, slides());
        ASSERT_FALSE(library.has_value()) << path;
        EXPECT_THAT(library.error().message, testing::StartsWith("cannot load the controller module "));
    }
    std::filesystem::remove(text);
    std::filesystem::remove(empty);
}

}  // namespace
}  // namespace gsim::rrs::rcs_host_test
