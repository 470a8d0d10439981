#include "cam/solid/contours.h"

#include <fmt/format.h>

#include "base/text/format.h"
#include "cam/solid/contours_packet.h"
#include "geometry/mesh/reader_process.h"

namespace gsim::solid {

Result<WallContours> read_contours(const std::filesystem::path& file, const ContourOptions& options) {
    std::vector<std::string> settings{fmt::format("{}", options.tolerance_mm), options.kind, options.side,
                                      options.along_walls ? "walls" : "any"};
    std::string box;
    if (options.box_mm) box = text::joined(*options.box_mm, " ");
    settings.push_back(box);
    for (const std::string& face : options.faces) settings.push_back("face:" + face);
    for (const std::string& edge : options.edges) settings.push_back("edge:" + edge);
    return query_reader_as("contours", file, settings, unpack_contours);
}

}  // namespace gsim::solid
