#pragma once

#include <string>

namespace gsim::studio {

/// Serves the page of the studio until a signal ends it. `argument` is the JSON object shown in
/// gsim_serve.cpp. Prints the address as the first line on standard output. Returns the exit status: 0, or 2
/// on an error, which is printed on standard error.
int serve_page(const std::string& argument);

}  // namespace gsim::studio
