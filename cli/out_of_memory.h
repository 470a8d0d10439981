#pragma once

namespace gsim::apps {

/// From here on the program ends where operator new finds no memory: its temporary files are removed, a
/// sentence goes to standard error, the status is kUsage. Nothing is unwound, as destructors (those of
/// nlohmann-json's values) may need memory, too, and others (the streams in toml++) make something else of
/// the exception. For main() alone.
void end_where_memory_lacks();

}  // namespace gsim::apps
