#include "tests/lua_lib/run.h"

#include <cmath>

#include "base/text/diagnostic_kind.h"
#include "codegen/translate.h"
#include "engine/src/run/word_table.h"
#include "machine/file/machine_file.h"

namespace gsim::script {

namespace {

class Collector : public simulation::RunOutput {
  public:
    explicit Collector(Outcome& run) : run_(run) {}
    void on_segment(const motion::Segment& segment, const simulation::MoveInfo&) override {
        run_.segments.push_back(segment);
    }
    void on_move(const simulation::RecordedMove& move) override { run_.moves.push_back(move); }

  private:
    Outcome& run_;
};

codegen::TranslateOptions in_dialect(std::string_view dialect) {
    codegen::TranslateOptions options;
    options.dialect = grammar::find_dialect(dialect);
    return options;
}

/// As gsim-run has it: function by function.
Script in_functions(const codegen::TextTranslation& translation) {
    Script script = Script::from_text(translation.lua, "part.nc", -1);
    for (const codegen::ProgramPart& part : translation.programs)
        script.functions.push_back({part.head, {{part.body_begin, part.body_end, part.first_line}}});
    return script;
}

void expect_same(const Outcome& full, const Outcome& in_functions) {
    EXPECT_EQ(simulation::to_json(full.report), simulation::to_json(in_functions.report)) << full.lua;
    ASSERT_EQ(full.moves.size(), in_functions.moves.size()) << full.lua;
    for (std::size_t i = 0; i < full.moves.size(); ++i) {
        EXPECT_EQ(full.moves[i].end, in_functions.moves[i].end);
        EXPECT_EQ(full.moves[i].end_s, in_functions.moves[i].end_s);
        EXPECT_EQ(full.moves[i].info.location.line, in_functions.moves[i].info.location.line);
    }
}

/// The code of the alarm in brackets, "[word-value]", or nothing without an alarm.
std::string code(const Outcome& run) {
    if (!run.report.alarm) return {};
    return "[" + std::string(text::diagnostic_code(run.report.alarm->kind)) + "]";
}

/// True if the text is in the message of the alarm, or is its code in brackets.
bool tells(const Outcome& run, const std::string& text) {
    return text.starts_with('[') ? code(run) == text : run.message().find(text) != std::string::npos;
}

}  // namespace

double Outcome::to(std::size_t n, char letter) const {
    const std::size_t axis = machine.find(letter).value();
    return machine::axis_value(machine.axes[axis], moves.at(n).end[static_cast<Eigen::Index>(axis)]);
}

std::array<double, 5> Outcome::end() const {
    if (moves.empty()) return {};
    const std::size_t last = moves.size() - 1;
    return {to(last, 'X'), to(last, 'Y'), to(last, 'Z'), to(last, 'B'), to(last, 'C')};
}

std::string Outcome::events() const {
    std::string kinds;
    for (const simulation::Event& event : report.events) kinds += (kinds.empty() ? "" : " ") + event.kind;
    return kinds;
}

machine::Machine built_in_machine() {
    return machine::read_machine(machine::built_in_machine_toml(), "built-in machine").value();
}

Conditions with_tools(Conditions setup) {
    setup.options.data.tools[1] = {.length_mm = 10, .diameter_mm = 6};
    setup.options.data.tools[2] = {.length_mm = 25, .diameter_mm = 4};
    return setup;
}

Outcome run_script(Script script, Conditions setup) {
    Outcome result;
    result.machine = setup.machine;
    simulation::Simulator simulator(result.machine, setup.limits);
    Collector collector(result);
    simulator.add_output(collector);
    simulator.probing().set_surface(setup.probe);
    if (!setup.overrides.changes().empty()) simulator.motion().set_overrides(setup.overrides);
    const std::string name = script.file_name;
    {
        if (setup.options.codes.empty())
            setup.options.codes = engine::word_table(*grammar::find_dialect(setup.options.dialect));
        Engine engine(simulator, std::move(setup.options));
        engine.run(std::move(script));
        result.report = simulator.finish(name);
        engine.report(result.report);
    }
    return result;
}

Outcome run(std::string_view gcode, Conditions setup) {
    const codegen::TextTranslation translation =
        codegen::translate_text(gcode, in_dialect(setup.options.dialect));
    EXPECT_TRUE(translation.ok) << translation.diagnostics;
    if (!translation.ok) return {};
    Outcome result = run_script(Script::from_text(translation.lua, "part.nc", -1), setup);
    result.lua = translation.lua;
    expect_same(result, run_script(in_functions(translation), std::move(setup)));
    return result;
}

Outcome run_lua(std::string_view lua, Conditions setup) {
    Outcome result = run_script(Script::from_text(std::string(lua), "part.lua", 0), std::move(setup));
    result.lua = lua;
    return result;
}

std::string diagnostics_text(std::string_view gcode, std::string_view dialect) {
    const codegen::TextTranslation translation = codegen::translate_text(gcode, in_dialect(dialect));
    EXPECT_FALSE(translation.ok) << translation.lua;
    return translation.diagnostics;
}

double trapezoid_s(double length, double speed, double acceleration) {
    if (length == 0) return 0;
    const bool reached = speed * speed / acceleration <= length;
    return reached ? length / speed + speed / acceleration : 2 * std::sqrt(length / acceleration);
}

void expect_end(const Outcome& run, double x, double y, double z, double b, double c) {
    EXPECT_TRUE(run.completed()) << run.message() << "\n" << run.lua;
    const std::array<double, 5> expected_value{x, y, z, b, c};
    const std::array<double, 5> got = run.end();
    for (std::size_t i = 0; i < 5; ++i)
        EXPECT_NEAR(got[i], expected_value[i], 1e-6) << "XYZBC"[i] << "\n" << run.lua;
}

void expect_alarm(const Outcome& run, std::uint32_t line, const std::vector<std::string>& texts) {
    EXPECT_EQ(run.report.status, simulation::RunStatus::alarm) << run.lua;
    EXPECT_EQ(run.line(), line) << run.message() << "\n" << run.lua;
    for (const std::string& text : texts)
        EXPECT_TRUE(tells(run, text)) << "wanted: " << text << "\ngot: " << code(run) << " " << run.message();
}

void expect_alarm(const Outcome& run, const std::string& text) {
    EXPECT_EQ(run.report.status, simulation::RunStatus::alarm) << run.lua;
    EXPECT_TRUE(tells(run, text)) << "wanted: " << text << "\ngot: " << code(run) << " " << run.message()
                                  << "\n"
                                  << run.lua;
}

void expect_stopped(const Outcome& run, const std::string& text) {
    EXPECT_EQ(run.report.status, simulation::RunStatus::stopped) << run.message() << "\n" << run.lua;
    EXPECT_NE(run.message().find(text), std::string::npos) << run.message();
}

}  // namespace gsim::script
