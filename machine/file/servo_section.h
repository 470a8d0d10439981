#pragma once

// For the readers of TOML files alone (toml_section.h).

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/toml/toml_section.h"
#include "base/toml/toml_text.h"
#include "machine/model/machine.h"

namespace gsim::machine {

/// The keys of an axis that tell of its servo loop.
std::vector<std::string_view> servo_keys();

/// What an axis says of its servo loop; nothing where it has no such key.
std::optional<Servo> read_servo(base::TomlSection& axis);

void print_servo(base::TomlText& out, const Axis& axis);

/// Why the servo loops of a machine are none, as a sentence; nothing if they are.
std::optional<std::string> find_servo_fault(const Machine& machine);

}  // namespace gsim::machine
