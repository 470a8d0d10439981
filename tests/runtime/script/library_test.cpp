// The library in Lua, replaced by a folder that a user has changed.

#include "tests/lua_lib/library_folder.h"

namespace gsim::script::library_test {
namespace {

using LibraryFolder = script::LibraryFolder;

TEST_F(LibraryFolder, CopyOfBuiltInLibraryRuns) {
    expect_end(run_here("G91() G0{x=5.0} G0{x=5.0}"), 10, 0, 0);
}

TEST_F(LibraryFolder, UserAddsAndChangesWords) {
    write("common/switches.lua",
          read("common/switches.lua") + "\nword(\"M77\", function() core.event(\"pallet\") end)\n");
    insert("ab9/modes.lua", "  if true then return core.event(\"valve\") end\n",
           "  local changed = state.flood or state.mist");
    const Outcome r = run_here("M77() M8() M9()");
    EXPECT_TRUE(r.completed()) << r.message();
    EXPECT_EQ(r.events(), "pallet jet_on valve jet_off") << "the machine file says what M9 switches";
}

TEST_F(LibraryFolder, KeepsUserDefinedArcWithPolarCoordinates) {
    remove("common/arcs.lua", "arc(\"G2\", false)");
    write("common/arcs.lua",
          read("common/arcs.lua") +
              "\nmotion.modal_word(\"G2\", function(words) path.event(\"pallet\", tostring(words.x)) end)\n");
    const Outcome r = run_here(
        "F(1000) G0{x=50, y=50} G3{x=70, i=10} G2{x=1} move{x=2} G16() G2{x=3} G15() move{x=4} G1{x=5}");
    EXPECT_TRUE(r.completed()) << r.message();
    EXPECT_EQ(r.events(), "pallet pallet pallet pallet");
    EXPECT_EQ(r.moves.size(), 3U);
}

TEST_F(LibraryFolder, ReportsErrorWithFileAndLine) {
    write("common/feed.lua", "word(\"F\", function(value)\n\nthis is no Lua\n");
    EXPECT_NE(error_text().find("lua_lib/common/feed.lua:3:"), std::string::npos) << error_text();
    write("common/feed.lua", "local x = nil\nx.y = 5\n");
    EXPECT_NE(error_text().find("lua_lib/common/feed.lua:2:"), std::string::npos) << error_text();
    write("common/feed.lua", "while true do end\n");
    EXPECT_NE(error_text(), "none");
}

TEST_F(LibraryFolder, ReportsMissingFileByName) {
    erase("common/arcs.lua");
    EXPECT_NE(error_text().find("arcs.lua"), std::string::npos) << error_text();
    erase("init.lua");
    EXPECT_NE(error_text().find("init.lua"), std::string::npos) << error_text();
}

TEST_F(LibraryFolder, ReportsErrorInWordAsAlarm) {
    insert("common/feed.lua", "word(\"M77\", function() local t = nil; t.x = 1 end)\n", "return {");
    const Outcome r = run_here("G0{x=1}\nM77()\n");
    EXPECT_EQ(r.report.status, simulation::RunStatus::alarm);
    EXPECT_NE(r.message().find("lua_lib/common/feed.lua"), std::string::npos) << r.message();
    EXPECT_EQ(r.line(), 2U);
}

}  // namespace
}  // namespace gsim::script::library_test
