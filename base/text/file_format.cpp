#include "base/text/file_format.h"

#include <fmt/format.h>

namespace gsim::text {

std::optional<Error> find_format_error(double format) {
    if (format == kFileFormat) return std::nullopt;
    return fmt::format("'format' is {}; this gsim reads format {}{}", format, kFileFormat,
                       format > kFileFormat ? ", so the file needs a newer gsim" : "");
}

}  // namespace gsim::text
