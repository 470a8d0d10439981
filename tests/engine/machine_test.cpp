#include "engine/machine.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/run.h"
#include "tests/engine/memory_files.h"

namespace gsim::engine::machine_test {
namespace {

using testing::HasSubstr;

TEST(Machine, FileReadsBackUnchanged) {
    const Machine built_in = Machine::read({}).value();
    Request request = make_request("", {{"own.toml", built_in.file()}});
    request.machine = "own.toml";
    EXPECT_EQ(Machine::read(request).value().file(), built_in.file());
}

TEST(Machine, RunsWithSharedMachineAgree) {
    Machine machine = Machine::read({}).value();
    ASSERT_TRUE(machine.read_bodies());
    std::string first;
    for (int i = 0; i < 2; ++i) {
        engine::Run run = engine::Run::open(make_request("a.nc", {{"a.nc", "G0 X5\nM2\n"}}), machine).value();
        ASSERT_TRUE(run.prepare());
        const std::string report = run.go().value().json();
        if (i == 0) first = report;
        EXPECT_EQ(report, first);
    }
}

TEST(Machine, CanBeCheckedWithoutProgram) {
    const Machine machine = Machine::read({}).value();
    const MachineCheck found = machine.check().value();
    EXPECT_TRUE(found.is_clean) << found.text;
    EXPECT_THAT(machine.axes_svg().value(), HasSubstr("<svg"));
}

TEST(Machine, RejectsInvalidFileWithSourceLocation) {
    Request request = make_request("", {{"own.toml", "[machine]\nname = 5\n"}});
    request.machine = "own.toml";
    EXPECT_THAT(Machine::read(request).error().message, HasSubstr("own.toml:2"));
}

}  // namespace
}  // namespace gsim::engine::machine_test
