#pragma once

#include <filesystem>
#include <string>
#include <type_traits>
#include <vector>

#include <fmt/format.h>
#include <tl/expected.hpp>

#include "base/error.h"
#include "geometry/mesh/packet.h"

namespace gsim::solid {

/// Runs gsim-solid, the program that reads STEP and IGES files through OpenCASCADE, on a file, and returns
/// the packet of its response. It is a separate process because OpenCASCADE crashes on some damaged files,
/// prints to standard output, and keeps global state. It also takes 40 ms to load, for which programs that
/// read no such file need not wait.
///
/// The error is a message that names the file: it does not exist, is too large, gsim-solid reports an error
/// in it or crashed, or this build has no gsim-solid.
Result<std::string> query_reader(const std::string& request, const std::filesystem::path& file,
                                 const std::vector<std::string>& settings);

/// Returns the result of `visit` for the packet (PacketReader), which it must consume completely.
template <typename MeshHandler>
auto query_reader_as(const std::string& request, const std::filesystem::path& file,
                     const std::vector<std::string>& settings, MeshHandler visit)
    -> Result<std::invoke_result_t<MeshHandler, PacketReader&>> {
    const auto response = query_reader(request, file, settings);
    if (!response) return tl::unexpected(response.error());
    PacketReader packet(*response);
    auto result = visit(packet);
    if (packet.is_complete()) return result;
    return Unexpected(fmt::format("'{}' cannot be read: gsim-solid did not finish", file.string()));
}

}  // namespace gsim::solid
