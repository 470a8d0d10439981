#include "apps/language_options.h"

namespace gsim::apps {

void add_language_options(CommandLine& line, engine::LanguageOptions& options) {
    line.add("--dialect", &options.dialect,
             "language of the part program: ab9 (Allen-Bradley 9/Series), rs274ngc (LinuxCNC), klipper, or "
             "the name of a controller; default: that of the machine file, else ab9")
        .suggest_values(engine::controller_names());
    line.add("--unknown", &options.unknown,
             "treatment of codes that the dialect does not have: an error, or skipped with a warning")
        .one_of({engine::LanguageOptions::kError, engine::LanguageOptions::kWarn})
        .show_default();
}

}  // namespace gsim::apps
