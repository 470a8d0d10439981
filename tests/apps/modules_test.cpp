// Modules that belong to a script: those that `require` finds, and those that it does not.

#include "tests/apps/run_program.h"

namespace gsim::apps::modules_test {
namespace {

class Modules : public Apps {
  protected:
    /// Returns the message for a script with this line.
    std::string said(const std::string& line) {
        write("main/part.lua", line + "\n");
        return gsim_run({"main/part.lua", "--quiet"}).err;
    }
};

TEST_F(Modules, AreFilesInScriptFolder) {
    write("main/shapes.lua",
          "local _ENV = require \"gsim\"\nlocal shapes = {}\nfunction shapes.side(a) G91() G1{x=a} G90() "
          "end\nreturn shapes\n");
    write("main/lib/two.lua", "v[500] = v[500] + 1\nreturn 2\n");
    EXPECT_EQ(said("local s = require \"shapes\" F(100) s.side(5) assert(s == require \"shapes\")"), "");
    EXPECT_EQ(
        said("assert(require \"lib.two\" == 2 and require \"lib.two\" == 2 and v[500] == 1, \"runs once\")"),
        "");
    write("main/gsim.lua", "return 5");
    write("main/math.lua", "return 5");
    EXPECT_EQ(said("assert(require \"gsim\".G1 == G1 and require \"math\".pi)"), "")
        << "the library's names are its own";
}

TEST_F(Modules, AreNotFoundOutsideScriptFolder) {
    write("outside.lua", "return 1");
    std::filesystem::create_directories(folder_ / "main");
    std::filesystem::create_symlink("../outside.lua", folder_ / "main/link.lua");
    EXPECT_EQ(said("require \"link\""),
              "main/part.lua:1: alarm: require \"link\": link.lua is a link to a file outside the folder of "
              "the script\n");
    const std::string names =
        "the name of a module may have letters, digits, _ and -, and dots for subfolders of the script's "
        "folder: \"lib.shapes\" is lib/shapes.lua there\n";
    for (const std::string name : {"../outside", "/etc/passwd", "..outside", "", "lib/two"})
        EXPECT_EQ(said("require \"" + name + "\""),
                  "main/part.lua:1: alarm: require \"" + name + "\": " + names);
    EXPECT_EQ(said("require \"none\""),
              "main/part.lua:1: alarm: require \"none\": the file none.lua does not exist in the folder of "
              "the script\n");
}

TEST_F(Modules, RaiseAlarmOnCircularRequire) {
    write("main/a.lua", "return require \"b\"");
    write("main/b.lua", "local a = require \"a\"\nreturn a");
    EXPECT_EQ(said("require \"a\""), "main/b.lua:1: alarm: the module \"a\" requires itself\n");
}

}  // namespace
}  // namespace gsim::apps::modules_test
