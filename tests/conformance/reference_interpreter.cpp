#include "tests/conformance/reference_interpreter.h"

#include <cstdio>
#include <memory>
#include <sstream>
#include <utility>

#include "tests/conformance/programs.h"

namespace gsim::conformance {

namespace fs = std::filesystem;

ReferenceInterpreter::ReferenceInterpreter(std::string command, const std::vector<ToolRow>& tools)
    : command_(std::move(command)), tools_(scratch_.write("tools.tbl", tool_table_text(tools))) {}

bool ReferenceInterpreter::is_installed() const {
    return canonical_output(scratch_.write("empty.ngc", "M2\n")).has_value();
}

std::optional<std::string> ReferenceInterpreter::canonical_output(const fs::path& program) const {
    const fs::path parameters = scratch_.path() / "parameters.var";  // it leaves its parameters there
    fs::remove(parameters);
    // It keeps its tools in a file of the home folder: two at once would share them.
    const std::string home = "HOME=" + scratch_.path().string();
    const auto output =
        command_output({"env", home, command_, "-g", "-t", tools_, "-v", parameters, program}, "/dev/null");
    return output ? std::optional(*output) : std::nullopt;
}

Result<std::optional<std::vector<ExpectedMove>>> ReferenceInterpreter::moves(const fs::path& program) const {
    const std::optional<std::string> output = canonical_output(program);
    if (!output) return std::nullopt;
    std::istringstream canon(*output);
    return read_canon(canon).map(
        [](std::vector<ExpectedMove>&& moves) { return std::optional(std::move(moves)); });
}

}  // namespace gsim::conformance
