#pragma once

#include <string>
#include <string_view>

namespace gsim::batch {

/// The name of a program's page: what can be read of the program's name, and a hash of all of it. The same
/// each night, another one for each program, and a plain name of a file in any folder.
std::string page_name(std::string_view program);

}  // namespace gsim::batch
