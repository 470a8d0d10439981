// The files of the library in Lua: what they share they say, and their order does not matter.

#include <algorithm>
#include <iterator>
#include <random>
#include <regex>

#include "codegen/translate.h"
#include "grammar/dialect.h"
#include "machine/file/machine_file.h"
#include "tests/build_files/build_files.h"
#include "tests/lua_lib/library_folder.h"

namespace gsim::script::library_files_test {
namespace {

constexpr int kOrders = 20;

class LibraryFiles : public LibraryFolder {
  protected:
    /// Returns the library's error for one of its own files with that text.
    std::string trouble_of(const std::string& name, const std::string& text) {
        write(name + ".lua", text);
        insert("init.lua", "use \"" + name + "\"\n", "for _, list in");
        return error_text();
    }

    /// The names of the files in the properties of a folder.
    std::vector<std::string> listed(const std::string& folder) {
        const std::string text = read(folder + "/properties.lua");
        const std::size_t begin = text.find("files = {");
        const std::string inside = text.substr(begin, text.find('}', begin) - begin);
        static const std::regex quoted(R"re("([\w/]+)")re");
        std::vector<std::string> names;
        for (std::sregex_iterator name(inside.begin(), inside.end(), quoted), end; name != end; ++name)
            names.push_back((*name)[1]);
        return names;
    }

    void write_order(const std::vector<std::string>& names) {
        std::string text = "return { {";
        for (const std::string& name : names) text += " \"" + name + "\",";
        write("files.lua", text + " } }\n");
    }
};

// --- What is refused when the library is loaded ---

TEST_F(LibraryFiles, RejectsDuplicateWord) {
    EXPECT_EQ(
        trouble_of("mine", "use(\"core/words\", \"word\")(\"G4\", function() end)\nuse \"common/feed\"\n"),
        "the Lua library cannot be loaded: 'G4' is defined twice, in lua_lib/mine.lua and in "
        "lua_lib/common/feed.lua");
    EXPECT_EQ(trouble_of("mine", "use \"common/expressions\"\nfunction env.SQRT() end\n"),
              "the Lua library cannot be loaded: 'SQRT' is defined twice, in lua_lib/common/expressions.lua "
              "and in lua_lib/mine.lua");
}

TEST_F(LibraryFiles, RejectsGlobalAndUndefinedNames) {
    EXPECT_EQ(trouble_of("mine", "\nhelper = 5\n"),
              "the Lua library cannot be loaded: lua_lib/mine.lua:2: 'helper' would be global for all files "
              "of the library; return it, or make it local");
    EXPECT_EQ(trouble_of("mine", "local x = helper\n"),
              "the Lua library cannot be loaded: lua_lib/mine.lua:1: the library does not define 'helper'");
    EXPECT_EQ(trouble_of("mine", "local helper = use(\"core/path\", \"helper\")\n"),
              "the Lua library cannot be loaded: lua_lib/mine.lua:1: lua_lib/core/path.lua does not return "
              "'helper'");
}

TEST_F(LibraryFiles, RejectsCircularDependency) {
    write("theirs.lua", "use \"mine\"\n");
    EXPECT_EQ(trouble_of("mine", "use \"theirs\"\n"),
              "the Lua library cannot be loaded: circular dependency of library files: mine needs theirs "
              "needs mine");
}

TEST_F(LibraryFiles, RejectsHookWithoutOrder) {
    EXPECT_EQ(
        trouble_of("mine", "use(\"core/words\", \"before\")(\"G4\", \"coffee\", function() end)\n"),
        "the Lua library cannot be loaded: hook 'coffee' is not in the order of lua_lib/core/hooks.lua");
    EXPECT_EQ(trouble_of("mine", "use(\"core/hooks\", \"on\")(\"begin\", \"tea\", function() end)\n"),
              "the Lua library cannot be loaded: hook 'tea' is not in the order of lua_lib/core/hooks.lua");
}

TEST_F(LibraryFiles, HooksRunInDefinedOrder) {
    const std::string text =
        "local path, words = use \"core/path\", use \"core/words\"\n"
        "words.after(\"M5\", \"times\", function() path.event(\"third\") end)\n"
        "words.after(\"M5\", \"compensation\", function() path.event(\"first\") end)\n"
        "words.after({ \"M4\", \"M5\" }, \"process\", function(name) path.event(name) end)\n"
        "words.before(\"M5\", \"times\", function() path.event(\"before\") end)\n";
    EXPECT_EQ(trouble_of("mine", text), "none");
    EXPECT_EQ(run_here("M3() M5()").events(), "spindle_cw before spindle_off first M5 third");
}

TEST_F(LibraryFiles, UserFileDefinesCode) {
    EXPECT_EQ(trouble_of("mine", "use(\"common/user_codes\")[101] = function(words) env.G0{x=words.p} end\n"),
              "none");
    EXPECT_EQ(trouble_of("other",
                         "use(\"core/words\", \"after\")(\"M101\", \"times\", function() env.G0{y=5} end)\n"),
              "none");
    expect_end(run_here("M[101]{p=7}"), 7, 5, 0);
}

TEST_F(LibraryFiles, FileScalesWordsOfAxis) {
    EXPECT_EQ(
        trouble_of(
            "mine",
            "use(\"core/words\", \"word\")(\"TWICE\", function() core.set_word_factor(\"y\", 2) end)\n"),
        "none");
    expect_end(run_here("TWICE() G0{x=3, y=4} G91() G0{y=1}"), 3, 10, 0);
    expect_end(run_here("TWICE() G20() G0{y=1}"), 0, 50.8, 0);
    expect_end(run_here("G0{y=6} TWICE() G92{y=1} G0{y=3}"), 0, 10, 0);
    expect_end(run_here("G0{y=6} TWICE() F(600) G1{y=4} G3{x=8, y=8, i=0, j=8}"), 8, 16, 0);
}

// --- The order of the files ---

struct Program {
    std::string name;
    std::string dialect;
    std::string gcode;
};

std::string sample(const std::string& name) {
    std::ifstream file(tests::source_path("samples/") + name);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// Programs in which files of the library act on each other's words.
std::vector<Program> programs() {
    const std::string ab9_offsets =
        "G21 F900 S500 M3\nT1 M6 D1 H1\nG43\nG41 G1 X20 Y20\nX60\nG55\nY60\nG54\nX20\nG40 Y10\nG68 X0 Y0 "
        "R30\n"
        "G1 X30\nG505\nX35\nG54\nG69\nG51.1 X50\nX40\nG50.1\n#500=#4007+#4120+#4109\nM8\nX10\nM9\nM5\nM30\n";
    const std::string ab9_macros =
        "F600\n#1=3\nG66 P20 A1 B2\nG0 X10\nX20\nG67\nG66.1 P20\nG1 X5 F300 S200\nG67\nG65 P20 A4\n"
        "G1 X30,C2\nY30,A90\nG16\nG1 X20 Y30\nG15\nG96 S100\nG81 X50 Y50 Z20 R40\nX60\nG80\nM30\n"
        "O20\n#100=#100+#1\nG4 P0.1\nM99\n";
    const std::string ngc_modes =
        "G21 F900 S500 M3\n#<_depth> = 2\no100 sub\nM73\nG91 G20\nG1 X[#1 / 25.4]\nM8\no100 endsub [#1 + 1]\n"
        "G1 X10\no100 call [5]\nM70\nG18 G61\nM72\nG1 Y[#<_value>]\nG10 L2 P2 X5 R10\nG55 G1 X3\nG92 "
        "X0\nG92.1\n"
        "G54\nG43 H1\nG41 D2\nG1 X40 Y40\nX60\nM1\nY60\nG40 G1 X0\nM62 P0\nG1 X10\nM63 P0\nM100 P1\n"
        "G81 X20 Y20 Z-2 R5\nG80\n(DEBUG, #<_x> #5420 #5220 #<_metric>)\nM5 M9\nM2\n";
    return {{"wheel", "ab9", sample("wheel.nc")},
            {"offsets", "ab9", ab9_offsets},
            {"macros", "ab9", ab9_macros},
            {"rosette", "rs274ngc", sample("rosette.ngc")},
            {"modes", "rs274ngc", ngc_modes}};
}

/// Returns conditions with a process that words switch, times that they take, a rule of stops, and a user
/// code.
Conditions busy_conditions(const std::string& dialect) {
    Conditions setup = with_tools();
    setup.options.dialect = dialect;
    setup.machine =
        machine::load_machine(std::filesystem::path(tests::source_path("samples/machines/unlimited.toml")))
            .value();
    setup.machine.process = machine::Process{.kind = machine::ProcessKind::laser,
                                             .on = {{.code = 62, .words = {{'P', 0}}}, {8, {}}, {3, {}}},
                                             .off = {{.code = 63, .words = {{'P', 0}}}, {9, {}}, {5, {}}},
                                             .checks = {}};
    setup.machine.times = {
        .tool_change_s = 8, .process_on_s = 0.3, .process_off_s = 0.2, .codes_s = {{100, 0.75}}};
    const std::string module = dialect == "ab9" ? "gsim" : "gsim.rs274ngc";
    setup.options.setup = Script::from_text(
        "local _ENV = require \"" + module + "\"\nM[100] = function(words) G4{p=0.5} end\n", "setup.lua", 0);
    setup.options.setup->dialect = dialect;
    return setup;
}

std::string library_report(const Program& program, const Library& library) {
    codegen::TranslateOptions options;
    options.dialect = grammar::find_dialect(program.dialect);
    const codegen::TextTranslation translation = codegen::translate_text(program.gcode, options);
    EXPECT_TRUE(translation.ok) << translation.diagnostics;
    Script script = Script::from_text(translation.lua, "part.nc", -1);
    script.dialect = program.dialect;
    Conditions setup = busy_conditions(program.dialect);
    setup.options.library = library;
    const Outcome run = run_script(std::move(script), std::move(setup));
    std::string reported = simulation::to_json(run.report);
    for (const simulation::RecordedMove& move : run.moves) {
        for (const double value : move.end) reported += std::to_string(value) + " ";
    }
    return reported;
}

class LibraryOrder : public LibraryFiles, public testing::WithParamInterface<const char*> {};

TEST_P(LibraryOrder, DoesNotAffectResult) {
    const std::string dialect = GetParam();
    std::vector<std::pair<Program, std::string>> expected_value;
    for (const Program& program : programs()) {
        if (program.dialect != dialect) continue;
        expected_value.emplace_back(program, library_report(program, Library()));
        EXPECT_NE(expected_value.back().second.find("\"status\": \"completed\""), std::string::npos)
            << program.name << expected_value.back().second.substr(0, 400);
    }
    ASSERT_GE(expected_value.size(), 2U);
    std::vector<std::string> names = listed("core");
    for (const std::string& folder : {std::string("common"), dialect}) {
        const std::vector<std::string> added = listed(folder);
        names.insert(names.end(), added.begin(), added.end());
    }
    ASSERT_GT(names.size(), 30U);
    std::mt19937 random(1);
    for (int order = 0; order < kOrders; ++order) {
        std::shuffle(names.begin(), names.end(), random);
        write_order(names);
        for (const auto& [program, report] : expected_value) {
            EXPECT_EQ(library_report(program, library()), report)
                << program.name << ": " << read("files.lua");
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Dialects, LibraryOrder, testing::Values("ab9", "rs274ngc"));

}  // namespace
}  // namespace gsim::script::library_files_test
