#pragma once

namespace gsim::os {

/// Where a standard stream was closed before the program began, the next file that is opened would take its
/// place and get what is printed. From here on such a stream is there, and fails. For main() alone, first of
/// all.
void hold_standard_streams();

}  // namespace gsim::os
