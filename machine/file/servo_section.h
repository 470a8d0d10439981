#pragma once

// Only for readers of TOML files (toml_section.h).

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/toml/toml_section.h"
#include "base/toml/toml_writer.h"
#include "machine/model/machine.h"

namespace gsim::machine {

/// Returns the keys of an axis for its servo loop.
std::vector<std::string_view> servo_keys();

/// Reads the servo loop of an axis; returns nothing if it has no such key.
std::optional<Servo> read_servo(base::TomlSection& axis);

void print_servo(base::TomlWriter& out, const Axis& axis);

/// Returns an error if the servo loops of a machine are invalid.
std::optional<Error> find_servo_error(const Machine& machine);

}  // namespace gsim::machine
