// gsim-solid: reads a STEP or IGES file for the other programs and responds with a packet.
//
//     gsim-solid mesh FILE TOLERANCE-MM
//     gsim-solid plate FILE TOLERANCE-MM flip|as-it-lies AXIS
//     gsim-solid contours FILE TOLERANCE-MM holes|outlines|all SIDE walls|any "X Y Z X Y Z" [face:FACE |
//     edge:EDGE ...]
//
// A packet begins with a success flag; on failure, an error message follows.

#include <Standard_Failure.hxx>
#include <array>
#include <cstdlib>
#include <exception>
#include <optional>
#include <span>
#include <string_view>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include "cam/solid/contours_packet.h"
#include "cam/solid/occ/contour_reader.h"
#include "cam/solid/occ/plate_reader.h"
#include "cam/solid/occ/shape_file.h"
#include "cam/solid/occ/tessellation.h"
#include "cam/solid/plate_packet.h"
#include "geometry/mesh/mesh_packet.h"

namespace {

using namespace gsim::solid;

using Reply = gsim::Result<PacketWriter>;

constexpr rlim_t kMaxCpu_s = 600;
constexpr rlim_t kMaxMemory_bytes = rlim_t{12} << 30U;

// Damaged files can make OpenCASCADE loop endlessly or request any amount of memory.
void limit_resources() {
    const rlimit cpu{kMaxCpu_s, kMaxCpu_s};
    ::setrlimit(RLIMIT_CPU, &cpu);
    const rlimit core{0, 0};
    ::setrlimit(RLIMIT_CORE, &core);
#ifndef GSIM_SANITIZES_ADDRESSES  // that reserves the full address space
    const rlimit memory{kMaxMemory_bytes, kMaxMemory_bytes};
    ::setrlimit(RLIMIT_DATA, &memory);
#endif
}

// Returns the descriptor for the packet. Only the packet may be written to standard output, but OpenCASCADE
// prints its remarks about a file there.
int redirect_output() {
    const int output = ::dup(STDOUT_FILENO);
    const int null_device = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    ::dup2(null_device, STDOUT_FILENO);
    ::dup2(null_device, STDERR_FILENO);
    return output;
}

Reply mesh_reply(const std::string& file, double tolerance_mm) {
    const auto shapes = ShapeFile::read(file);
    if (!shapes) return tl::unexpected(shapes.error());
    const auto mesh = tessellate(shapes->shape(), tolerance_mm);
    if (!mesh) return tl::unexpected(mesh.error());
    PacketWriter packet;
    packet.write_flag(true);
    pack_mesh(packet, *mesh);
    return packet;
}

Reply plate_reply(const std::string& file, const PlateOptions& options) {
    const auto shapes = ShapeFile::read(file);
    if (!shapes) return tl::unexpected(shapes.error());
    const auto plate = extract_plate(*shapes, options);
    if (!plate) return tl::unexpected(plate.error());
    PacketWriter packet;
    packet.write_flag(true);
    pack_plate(packet, *plate);
    return packet;
}

std::optional<std::array<double, 6>> parse_box(const char* text) {
    std::array<double, 6> box_mm{};
    for (double& value : box_mm) {
        char* end = nullptr;
        value = std::strtod(text, &end);
        if (end == text) return std::nullopt;
        text = end;
    }
    return box_mm;
}

Reply contours_reply(std::span<char* const> arguments) {
    const auto shapes = ShapeFile::read(arguments[2]);
    if (!shapes) return tl::unexpected(shapes.error());
    ContourOptions options;
    options.tolerance_mm = std::strtod(arguments[3], nullptr);
    options.kind = arguments[4];
    options.side = arguments[5];
    options.along_walls = arguments[6] == std::string_view("walls");
    options.box_mm = parse_box(arguments[7]);
    for (const std::string_view each : arguments.subspan(8)) {
        const std::size_t colon = each.find(':');
        auto& names = each.substr(0, colon) == "edge" ? options.edges : options.faces;
        names.emplace_back(each.substr(colon + 1));
    }
    const auto contours = extract_contours(*shapes, options);
    if (!contours) return tl::unexpected(contours.error());
    PacketWriter packet;
    packet.write_flag(true);
    pack_contours(packet, *contours);
    return packet;
}

Reply response(std::span<char* const> arguments) {
    const std::string_view request = arguments[1];
    const double tolerance_mm = std::strtod(arguments[3], nullptr);
    if (request == "mesh") return mesh_reply(arguments[2], tolerance_mm);
    if (request == "contours" && arguments.size() > 7) return contours_reply(arguments);
    if (request == "plate" && arguments.size() > 5)
        return plate_reply(arguments[2],
                           {tolerance_mm, arguments[4] == std::string_view("flip"), arguments[5]});
    return gsim::Unexpected("gsim-solid is of another version than the program that runs it");
}

Reply guarded_reply(std::span<char* const> arguments) {
    try {
        return response(arguments);
    } catch (const Standard_Failure& error) {
        return gsim::Unexpected(fmt::format("OpenCASCADE cannot read it: {}", error.GetMessageString()));
    } catch (const std::exception& error) {
        return gsim::Unexpected(fmt::format("it cannot be read: {}", error.what()));
    }
}

bool write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
        if (count <= 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 4 || ::isatty(STDOUT_FILENO) != 0) {
        constexpr std::string_view kUsageText =
            "gsim-solid reads STEP and IGES files for gsim-run and autopath; do not run it directly\n";
        write_all(STDERR_FILENO, kUsageText);
        return 2;
    }
    limit_resources();
    const int output = redirect_output();
    const Reply reply = guarded_reply({argv, static_cast<std::size_t>(argc)});
    PacketWriter error;
    if (!reply) {
        error.write_flag(false);
        error.write_text(reply.error().message);
    }
    const bool written = write_all(output, reply ? reply->bytes() : error.bytes());
    // The response is sent. Shutting OpenCASCADE down would take time and could still fail.
    std::_Exit(written ? 0 : 1);
}
