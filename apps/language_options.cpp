#include "apps/language_options.h"

namespace gsim::apps {

void add_language_options(CommandLine& line, engine::LanguageChoice& choice) {
    line.add("--dialect", &choice.dialect,
             "language of the part program: ab9 (Allen-Bradley 9/Series), rs274ngc (LinuxCNC), klipper, or "
             "the "
             "name of a control; without it that of the machine file, else ab9")
        .suggests(engine::control_names());
    line.add("--unknown", &choice.unknown,
             "what a code is that the dialect does not have: an error, or left out with a warning")
        .one_of({engine::LanguageChoice::kError, engine::LanguageChoice::kWarn})
        .shows_default();
}

}  // namespace gsim::apps
