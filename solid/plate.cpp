#include "solid/plate.h"

#include <fmt/format.h>

#include "solid/plate_packet.h"
#include "solid/reader_process.h"

namespace gsim::solid {

tl::expected<Plate, std::string> read_plate(const std::filesystem::path& file, const PlateOptions& options) {
    const auto answer = ask_reader(
        "plate", file,
        {fmt::format("{}", options.tolerance_mm), options.flip ? "flip" : "as-it-lies", options.along});
    if (!answer) return tl::unexpected(answer.error());
    PacketReader packet(*answer);
    Plate plate = take_plate(packet);
    if (packet.is_whole()) return plate;
    return tl::unexpected(fmt::format("'{}' cannot be read: gsim-solid did not finish", file.string()));
}

}  // namespace gsim::solid
