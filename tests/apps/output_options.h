#pragma once

#include <string>
#include <vector>

#include "apps/outputs.h"

namespace gsim::apps {

/// Returns the options of a run's output files. It omits the picture, which needs the extension of a picture,
/// and the page, which a build may lack. The report's option is the first one.
inline std::vector<std::string> output_options() {
    std::vector<std::string> options;
    for (const OutputNames::File& file : OutputNames::files()) {
        const bool is_odd = file.output_kind == engine::OutputKind::plot || file.name == &OutputNames::view;
        if (!is_odd) options.emplace_back(file.option);
    }
    return options;
}

/// The same without the report.
inline std::vector<std::string> document_options() {
    std::vector<std::string> options = output_options();
    options.erase(options.begin());
    return options;
}

/// "out/moves" of "--moves".
inline std::string file_of_option(const std::string& option, const std::string& folder = {}) {
    return folder + option.substr(2);
}

}  // namespace gsim::apps
