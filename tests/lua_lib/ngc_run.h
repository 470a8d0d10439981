#pragma once

#include <filesystem>
#include <string>

#include "machine/file/machine_file.h"
#include "tests/build_files/build_files.h"
#include "tests/lua_lib/run.h"

namespace gsim::script {

/// The dialect rs274ngc on the machine of nine axes without limits, with two tools.
inline Conditions ngc_conditions() {
    Conditions setup = with_tools();
    setup.machine =
        machine::load_machine(std::filesystem::path(tests::source_path("samples/machines/unlimited.toml")))
            .value();
    setup.options.dialect = "rs274ngc";
    return setup;
}

/// Translates and runs an RS274/NGC program.
inline Outcome run_ngc(const std::string& gcode, Conditions setup = ngc_conditions()) {
    return run(gcode, std::move(setup));
}

/// Runs a script of that dialect; its first line is the one given here.
inline Outcome run_ngc_lua(const std::string& lua, Conditions setup = ngc_conditions()) {
    Script script = Script::from_text("local _ENV = require \"gsim.rs274ngc\" " + lua, "part.lua", 0);
    script.dialect = setup.options.dialect = "rs274ngc";
    Outcome result = run_script(std::move(script), std::move(setup));
    result.lua = lua;
    return result;
}

/// The texts of all (DEBUG,) comments, one to a line.
inline std::string debug_texts(const Outcome& run) {
    std::string texts;
    for (const simulation::Event& event : run.report.events)
        if (event.kind == "debug") texts += event.detail + "\n";
    return run.completed() ? texts : run.message();
}

}  // namespace gsim::script
