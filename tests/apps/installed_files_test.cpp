// Files of an installation, found from the program's location, wherever that is.

#include "engine/system/installed_files.h"

#include <fstream>

#include <fmt/format.h>

#include "base/os/installation.h"
#include "tests/apps/run_program.h"
#include "tests/build_files/build_files.h"

namespace gsim::apps::installed_files_test {
namespace {

namespace fs = std::filesystem;

class InstalledFiles : public Apps {
  protected:
    // An installation below the test's folder.
    fs::path install(const std::string& file) const {
        const fs::path path = folder_ / "opt" / file;
        fs::create_directories(path.parent_path());
        std::ofstream(path) << "here\n";
        return path;
    }
    fs::path bin() const { return folder_ / "opt" / "bin"; }
};

TEST_F(InstalledFiles, AreFoundFromProgramFolder) {
    const fs::path machine = install("share/gsim/samples/machines/lonely.toml");
    const fs::path part = install("share/gsim/samples/only_here.nc");
    EXPECT_EQ(engine::find_file_from(bin(), engine::NameKind::machine, "lonely").value(), machine.string());
    EXPECT_EQ(
        engine::find_file_from(bin(), engine::NameKind::machine, "samples/machines/lonely.toml").value(),
        machine.string());
    EXPECT_EQ(engine::find_file_from(bin(), engine::NameKind::sample, "samples/only_here.nc").value(),
              part.string());
    const fs::path module = os::module_folders(bin()).front() / "libown_planner.so";
    fs::create_directories(module.parent_path());
    std::ofstream(module) << "";
    EXPECT_EQ(engine::find_file_from(bin(), engine::NameKind::module, "own_planner").value(),
              module.string());
    EXPECT_EQ(engine::find_file_from(bin(), engine::NameKind::module, "libown_planner.so").value(),
              module.string());
}

TEST_F(InstalledFiles, UserFileHasPriority) {
    install("share/gsim/samples/machines/router3.toml");
    const std::string own = (folder_ / "router3").string();
    std::ofstream(own) << "";
    EXPECT_EQ(engine::find_file_from(bin(), engine::NameKind::machine, own).value(), own);
    EXPECT_EQ(engine::find_file_from(bin(), engine::NameKind::machine, "-").value(), "-");
    EXPECT_EQ(engine::find_file_from(bin(), engine::NameKind::machine, "").value(), "");
}

// A name with its extension means the user's own file: a sample in its place would be another machine.
TEST_F(InstalledFiles, MissingFileReportsSearchedFolder) {
    install("share/gsim/samples/machines/router3.toml");
    EXPECT_EQ(engine::find_file_from(bin(), engine::NameKind::machine, "router3.toml").error().message,
              "cannot read 'router3.toml': No such file or directory; did you mean 'router3'?");
    EXPECT_EQ(engine::find_file_from(bin(), engine::NameKind::machine, "ruter3").error().message,
              fmt::format("cannot read 'ruter3': No such file or directory, nor does "
                          "'{}/opt/share/gsim/samples/machines/ruter3.toml' exist; did you mean 'router3'?",
                          folder_.string()));
    EXPECT_EQ(engine::find_file_from(bin(), engine::NameKind::sample, "samples/nowhere.nc").error().message,
              fmt::format("cannot read 'samples/nowhere.nc': No such file or directory, nor does "
                          "'{}/opt/share/gsim/samples/nowhere.nc' exist",
                          folder_.string()));
    EXPECT_EQ(engine::find_file_from(bin(), engine::NameKind::sample, "/none.nc").error().message,
              "cannot read '/none.nc': No such file or directory");
}

// The programs of a build folder, which has what an installation has.
TEST_F(InstalledFiles, AreFoundByProgramsInEmptyFolder) {
    const Ended run = gsim_run({"--machine", "grbl-router", "--dialect", "rs274ngc", "samples/rosette.ngc"});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(gcode2lua({"--check", "samples/wheel.nc"}).status, 0);
    EXPECT_EQ(gsim_run({"--lua-lib", "lua_lib", "samples/wheel.nc"}).status, 0);
    EXPECT_EQ(gsim_run({"--rcs", "gsim_rcs_default", "samples/wheel.nc"}).status, 0);
    EXPECT_EQ(gsim_run({"--check-machine", "router3"}).status, 0);
    EXPECT_EQ(gsim_run({"--robots", "samples/cell/robots.toml", "samples/cell/cell.lua"}).status, 0);
    EXPECT_EQ(run_program(tests::program_path("path2gcode"),
                          {"--dialect", "samples/posts/grbl.toml", "--machine", "grbl-router",
                           "samples/wheel.path.json"},
                          folder_)
                  .err.find("cannot read"),
              std::string::npos);
    const Ended none = gsim_run({"--machine", "rooter3", "samples/wheel.nc"});
    EXPECT_EQ(none.status, 2);
    EXPECT_TRUE(
        contains(none.err, "share/gsim/samples/machines/rooter3.toml' exist; did you mean 'router3'?"))
        << none.err;
}

}  // namespace
}  // namespace gsim::apps::installed_files_test
