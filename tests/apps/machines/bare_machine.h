#pragma once

#include <string>

namespace gsim::apps {

/// The text of the built-in machine's file without its bodies.
inline std::string without_bodies(std::string machine_toml) {
    const std::size_t ignore = machine_toml.find("ignore = ");
    machine_toml.erase(ignore, machine_toml.find('\n', ignore) - ignore);
    return machine_toml.substr(0, machine_toml.find("[[shape]]"));
}

}  // namespace gsim::apps
