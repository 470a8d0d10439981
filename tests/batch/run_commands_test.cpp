#include "batch/work/run_commands.h"

#include <gmock/gmock.h>

namespace gsim::batch::run_commands_test {
namespace {

using testing::ElementsAre;

TEST(ViewCommand, ServesFolderWithAllFiles) {
    const auto line = [](const std::string& machine, const std::string& program) {
        return shell_line(
            studio_command({.program = program, .machine = machine, .options = "{}", .settings = "{}"})
                .words);
    };
    EXPECT_EQ(line("m.toml", "programs/a.nc"), "gsim studio --machine m.toml . programs/a.nc");
    EXPECT_EQ(line("af5-measured", "/data/p/a.nc"),
              "gsim studio --machine af5-measured /data/p /data/p/a.nc");
    EXPECT_EQ(line("/data/machines/m.toml", "/data/p/a.nc"),
              "gsim studio --machine /data/machines/m.toml /data /data/p/a.nc");
    EXPECT_EQ(line("/data/m.toml", "a.nc"), "") << "no folder is known to have both";
    EXPECT_EQ(line("m.toml", "../a.nc"), "");
    EXPECT_EQ(line("", "it's here/-a $x.nc"), R"(gsim studio . 'it'\''s here/-a $x.nc')");
    EXPECT_EQ(line("", "-a.nc"), "gsim studio . ./-a.nc");
}

TEST(ViewCommand, ReportsUnsupportedSettings) {
    const RunInputs run{
        .program = "a.nc",
        .machine = "m.toml",
        .options = R"({"block_delete":true,"cell":"c.toml","collisions":false,"variables":"v"})",
        .settings = R"({"machine.axis.X.max_mm":5,"option.feed_override_percent":80})"};
    const ViewCommand view = view_command(run);
    EXPECT_EQ(shell_line(view.words),
              "gsim run --view run.html --machine m.toml --block-delete --cell c.toml --no-collisions "
              "--feed-override 80 a.nc");
    EXPECT_THAT(view.left_out, ElementsAre("machine.axis.X.max_mm", "variables"));
    const ViewCommand studio = studio_command(run);
    EXPECT_EQ(shell_line(studio.words), "gsim studio --machine m.toml --cell c.toml . a.nc");
    EXPECT_THAT(studio.left_out, ElementsAre("machine.axis.X.max_mm", "block_delete", "collisions",
                                             "feed_override_percent", "variables"));
}

TEST(ViewCommand, RepeatsRunOfJob) {
    const Job job{
        .program = "best/a b.nc",
        .machine = "best/a.machine.toml",
        .options = {{"lower_bound", true}, {"joint_speeds", true}, {"cell", "c.toml"}, {"collisions", true}},
        .settings = {{"option.max_blocks", 5}}};
    const ViewCommand run = run_command(run_inputs(job));
    EXPECT_EQ(shell_line(run.words),
              "gsim run --machine best/a.machine.toml --cell c.toml --explain --max-blocks 5 'best/a b.nc'");
    EXPECT_THAT(run.left_out, ElementsAre());
    const Job path{
        .program = "a.path.json", .machine = "", .options = nlohmann::json::object(), .settings = {}};
    EXPECT_TRUE(run_command(run_inputs(path)).words.empty()) << "gsim run takes no path";
}

}  // namespace
}  // namespace gsim::batch::run_commands_test
