#include "engine/src/run/aliases.h"

namespace gsim::engine {

tl::expected<lexer::Aliases, std::string> aliases_of(const machine::MachineData& data) {
    lexer::Aliases aliases;
    for (const auto& [name, code] : data.aliases) {
        if (const std::optional<std::string> trouble = aliases.add(name, code))
            return tl::unexpected(*trouble);
    }
    return aliases;
}

}  // namespace gsim::engine
