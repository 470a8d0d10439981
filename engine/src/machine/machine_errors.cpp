#include "engine/machine_errors.h"

#include <string>
#include <vector>

#include "collision/cell/cell_file.h"
#include "engine/src/conversions.h"
#include "engine/src/guard_exceptions.h"
#include "engine/src/machine/machine_input.h"
#include "engine/src/run/run_inputs.h"

namespace gsim::engine {

namespace {

using Messages = std::vector<std::string>;

Messages find_errors(const Request& request) {
    const auto found = resolve_machine_files(request);
    if (!found) return {found.error().message};
    Messages errors;
    const auto input =
        read_machine_input(request.host, found->request.machine, found->machine_named_by, &errors);
    if (!input) return errors;
    const CellSource cell_source = make_cell_source(*found);
    const auto cell = cell_source.file.empty()
                          ? read_cell_contents(cell_source, input->machine)
                          : cell::read_cell(cell_source.text, cell_source.file, input->machine, {},
                                            cell_source.files, &errors);
    if (!cell && errors.empty()) errors.push_back(cell.error().message);
    return errors;
}

}  // namespace

std::vector<Diagnostic> find_machine_errors(const Request& request) {
    const auto errors =
        guard_exceptions([&]() -> tl::expected<Messages, Error> { return find_errors(request); });
    std::vector<Diagnostic> diagnostics;
    for (const std::string& error : errors ? *errors : Messages{errors.error().message})
        diagnostics.push_back(to_diagnostic(text::to_diagnostic(text::DiagnosticKind::input_file, error)));
    return diagnostics;
}

}  // namespace gsim::engine
