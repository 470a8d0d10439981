#include "cam/solid/plate.h"

#include <fmt/format.h>

#include "cam/solid/plate_packet.h"
#include "geometry/mesh/reader_process.h"

namespace gsim::solid {

tl::expected<Plate, std::string> read_plate(const std::filesystem::path& file, const PlateOptions& options) {
    return ask_reader_for(
        "plate", file,
        {fmt::format("{}", options.tolerance_mm), options.flip ? "flip" : "as-it-lies", options.along},
        take_plate);
}

}  // namespace gsim::solid
