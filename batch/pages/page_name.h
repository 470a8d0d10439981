#pragma once

#include <string>
#include <string_view>

namespace gsim::batch {

/// Returns the name of a program's page: the readable part of the program's name, and a hash of all of it.
/// The name is the same in each nightly report, unique for each program, and a plain file name in any folder.
std::string page_name(std::string_view program);

}  // namespace gsim::batch
