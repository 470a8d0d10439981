#include "cam/solid/plate.h"

#include <fmt/format.h>

#include "cam/solid/plate_packet.h"
#include "geometry/mesh/reader_process.h"

namespace gsim::solid {

Result<Plate> read_plate(const std::filesystem::path& file, const PlateOptions& options) {
    return query_reader_as(
        "plate", file,
        {fmt::format("{}", options.tolerance_mm), options.flip ? "flip" : "as-it-lies", options.facing_axis},
        unpack_plate);
}

}  // namespace gsim::solid
