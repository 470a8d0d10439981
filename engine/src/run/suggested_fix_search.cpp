#include "engine/src/run/suggested_fix_search.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "base/units.h"
#include "engine/src/run/program_run.h"

namespace gsim::engine {

namespace {

using simulation::OffsetShift;

// First work offset variable of RS274/NGC, in inches: #5221 is X of G54.
constexpr int kFirstOffsetVariable = 5221;
constexpr int kVariablesPerOffset = 20;
constexpr double kMmPerVariableUnit = kMmPerInch;
constexpr std::array<std::string_view, 9> kOffsetNames{"54", "55",   "56",   "57",  "58",
                                                       "59", "59.1", "59.2", "59.3"};

/// Returns the variable of a work offset's X, Y or Z, if the data have it.
double* find_variable(machine::MachineData& data, std::string_view code, char axis) {
    const auto name = std::find(kOffsetNames.begin(), kOffsetNames.end(), code);
    if (name == kOffsetNames.end() || axis < 'X' || axis > 'Z') return nullptr;
    const int number = kFirstOffsetVariable +
                       kVariablesPerOffset * static_cast<int>(name - kOffsetNames.begin()) + (axis - 'X');
    const auto found = data.variables.find(number);
    return found == data.variables.end() ? nullptr : &found->second;
}

void shift_offset(machine::MachineData& data, const OffsetShift& shift, bool has_variables) {
    const std::string code = shift.offset.substr(1);
    machine::AxisValues& offset = data.offsets[code];
    double* variable =
        has_variables && !offset.contains(shift.axis) ? find_variable(data, code, shift.axis) : nullptr;
    if (variable != nullptr) {
        *variable += shift.shift_mm / kMmPerVariableUnit;
    } else {
        offset[shift.axis] += shift.shift_mm;
    }
}

}  // namespace

SuggestedFixSearch::SuggestedFixSearch(const ResolvedRequest& found, const RunInputs& inputs,
                                       os::CpuLimit& cpu)
    : found_(found),
      cpu_limit_(cpu),
      machine_(inputs.machine),
      data_(inputs.data),
      language_(inputs.language),
      program_(inputs.program),
      setup_(inputs.setup),
      probe_(inputs.probe) {}

void SuggestedFixSearch::search(simulation::Report& report) const {
    if (report.status != simulation::RunStatus::violations || report.violations.shifts.empty()) return;
    if (!found_.request.module.empty() || !is_fixed_by(report.violations.shifts)) return;
    report.violations.suggested_fix = report.violations.shifts;
}

bool SuggestedFixSearch::is_fixed_by(const std::vector<OffsetShift>& shifts) const {
    machine::MachineData data = data_;
    for (const OffsetShift& shift : shifts)
        shift_offset(data, shift, language_.dialect->rules().offset_variables);
    const auto cell = make_cell_monitor(make_cell_source(found_), machine_);
    if (!cell) return false;
    simulation::RunLimits limits = run_limits(found_.request, cpu_limit_);
    limits.stop_at_first = true;
    simulation::Simulator simulator(machine_, limits);
    simulator.set_cell(**cell);
    simulator.probing().set_surface(probe_);
    const TextDiagnosticHandler on_diagnostic = [](const text::Diagnostic&) {
    };  // the first run has reported them
    script::Engine::Options options = engine_options(found_.request, std::move(data), language_,
                                                     {.cpu = cpu_limit_, .on_diagnostic = on_diagnostic});
    options.setup = setup_;
    script::Engine engine(simulator, options);
    engine.run(script::Script(program_));
    return simulator.finish(program_.file_name).status == simulation::RunStatus::completed;
}

}  // namespace gsim::engine
