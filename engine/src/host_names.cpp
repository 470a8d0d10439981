#include "engine/src/host_names.h"

namespace gsim::engine {

Result<std::string> resolve_name(const Host& host, NameKind kind, const std::string& name) {
    if (name.empty() || !host.find) return name;
    return host.find(kind, name);
}

}  // namespace gsim::engine
