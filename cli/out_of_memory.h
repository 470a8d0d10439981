#pragma once

namespace gsim::apps {

/// Makes the program end if operator new finds no memory, from here on: its temporary files are removed, a
/// message is written to standard error, the status is kUsageError. It does not unwind, because destructors
/// (those of nlohmann-json's values) may need memory, too. Others (the streams in toml++) convert the
/// exception to something else. For main() alone.
void exit_on_out_of_memory();

}  // namespace gsim::apps
