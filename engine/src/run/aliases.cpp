#include "engine/src/run/aliases.h"

namespace gsim::engine {

Result<lexer::Aliases> make_aliases(const machine::MachineData& data) {
    lexer::Aliases aliases;
    for (const auto& [name, code] : data.aliases) {
        if (const std::optional<std::string> error = aliases.add(name, code)) return tl::unexpected(*error);
    }
    return aliases;
}

}  // namespace gsim::engine
