// A dialect that a test describes by its differences from ab9, in C++ and in Lua: one folder, no other file
// of the library but the list of dialects.

#include <array>

#include "codegen/translate.h"
#include "engine/src/run/word_table.h"
#include "grammar/rows.h"
#include "tests/lua_lib/library_folder.h"

namespace gsim::script::derived_dialect_test {
namespace {

using grammar::Code;
using grammar::Dialect;
using grammar::DialectRules;

constexpr std::array kCodes = {
    Code{'G', 350, grammar::Group::none, grammar::Phase::data, grammar::AxisUse::data, "",
         grammar::Support::full, "rapid to half of the coordinates"},
};

void change(DialectRules& rules) {
    rules.name = "x";
    rules.title = "X";
    rules.lua_module = "gsim.x";
    rules.text.has_power_operator = true;
    grammar::set_rows(rules.codes, kCodes);
    grammar::remove_rows(rules.codes, {{'G', 680}, {'G', 690}});
}

class DerivedLibrary : public LibraryFolder {
  protected:
    DerivedLibrary() {
        write("dialects.lua", "return { \"ab9\", \"rs274ngc\", \"klipper\", \"x\" }\n");
        set_properties("max_call_depth = 2");
        write("x/halves.lua",
              "local word = use(\"core/words\", \"word\")\n"
              "word(\"G35\", function(words) env.G0 { x = words.x / 2 } end)\n"
              "function env.POW(a, b) return a ^ b end\n");
        write("x/ramps.lua", "use(\"core/words\", \"word\")(\"G48\", function() env.G0 { z = 3 } end)\n");
    }
    void set_properties(const std::string& properties) {
        write("x/properties.lua",
              "return { base = \"ab9\", module = \"gsim.x\", files = { \"x/halves\", "
              "\"x/ramps\" },\n  " +
                  properties + " }\n");
    }
    Outcome run_derived(const std::string& gcode) {
        const Dialect x(grammar::dialect_ab9(), change);
        codegen::TranslateOptions options;
        options.dialect = &x;
        const codegen::TextTranslation translation = codegen::translate_text(gcode, options);
        EXPECT_TRUE(translation.ok) << translation.diagnostics;
        Conditions setup;
        setup.options.library = library();
        setup.options.dialect = "x";
        setup.options.codes = engine::word_table(x);
        Script script = Script::from_text(translation.lua, "part.nc", -1);
        script.dialect = "x";
        return run_script(std::move(script), std::move(setup));
    }
};

TEST_F(DerivedLibrary, HasWordsOfBaseAndAddedWords) {
    expect_end(run_derived("G90 G0 X10\nG35 X8\nG55 G1 Y5 F900\n#1=2**3\nG0 Z#1\nM30\n"), 4, 5, 8);
}

TEST_F(DerivedLibrary, ReplacesFileOfItsBase) {
    expect_end(run_derived("G0 X1\nG48\n"), 1, 0, 3);
}

TEST_F(DerivedLibrary, HasChangedProperty) {
    const std::string calls = "M98 P1\nM30\nO1\nM98 P2\nM99\nO2\nG0 X1\nM99\n";
    expect_end(run_derived(calls), 1, 0, 0);
    set_properties("max_call_depth = 1");
    expect_alarm(run_derived(calls), "nested more than 1 deep");
}

TEST_F(DerivedLibrary, RejectsUnknownProperty) {
    EXPECT_EQ(error_text(), "none");
    insert("common/feed.lua", "local width = use(\"core/dialect\", \"width\")\n", "local");
    EXPECT_EQ(error_text(), "the Lua library cannot be loaded: a dialect has no property 'width'");
}

}  // namespace
}  // namespace gsim::script::derived_dialect_test
