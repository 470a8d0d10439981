#include "engine/machine_faults.h"

#include <string>
#include <vector>

#include "collision/cell/cell_file.h"
#include "engine/src/guarded.h"
#include "engine/src/machine/machine_input.h"
#include "engine/src/run/run_inputs.h"
#include "engine/src/values.h"

namespace gsim::engine {

namespace {

using Sentences = std::vector<std::string>;

Sentences faults_of(const Request& request) {
    const auto found = with_machine_files_found(request);
    if (!found) return {found.error()};
    Sentences faults;
    const auto input =
        read_machine_input(request.host, found->request.machine, found->machine_named_by, &faults);
    if (!input) return faults;
    const CellChoice choice = cell_choice(*found);
    const auto cell = choice.file.empty() ? read_cell_of_run(choice, input->machine)
                                          : cell::read_cell(choice.text, choice.file, input->machine, {},
                                                            choice.files, &faults);
    if (!cell && faults.empty()) faults.push_back(cell.error());
    return faults;
}

}  // namespace

std::vector<Diagnostic> find_machine_faults(const Request& request) {
    const auto faults = guarded([&]() -> tl::expected<Sentences, Failure> { return faults_of(request); });
    std::vector<Diagnostic> told;
    for (const std::string& fault : faults ? *faults : Sentences{faults.error().message})
        told.push_back(diagnostic_of(text::diagnostic_of(text::DiagnosticKind::input_file, fault)));
    return told;
}

}  // namespace gsim::engine
