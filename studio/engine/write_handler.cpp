// Writes a path file as a part program.

#include <array>
#include <map>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "engine/machine.h"
#include "engine/path_translation.h"
#include "studio/engine/key_reader.h"
#include "studio/engine/message.h"
#include "studio/engine/request_handlers.h"

namespace gsim::studio {

using engine::Offsets;
using engine::PathRequest;
using nlohmann::json;

namespace {

constexpr std::array kOffsetNames{"as_path", "keep", "none", "machine"};
constexpr std::array kOffsets{Offsets::as_path, Offsets::keep, Offsets::none, Offsets::machine};
static_assert(kOffsetNames.size() == kOffsets.size());

constexpr int kMaxDecimals = 6;
constexpr int kMaxTool = 99'999'999;
constexpr double kMaxPosition_mm = 1e6;
constexpr double kMinTolerance_mm = 1e-4;
constexpr double kMaxTolerance_mm = 10;

tl::expected<PathRequest, engine::Error> path_request(const json& parameters) {
    PathRequest request;
    request.post = "ab9";
    std::optional<std::size_t> offsets;
    KeyReader keys(parameters, "write");
    keys.required_text("path", request.path);
    keys.text("post", request.post);
    keys.text("program_name", request.program_name);
    keys.boolean("rotary_as_given", request.rotary_as_given);
    keys.word("offsets", kOffsetNames, offsets);
    keys.text("work_offset", request.work_offset);
    keys.point("set_offset_mm", -kMaxPosition_mm, kMaxPosition_mm, request.set_offset_mm);
    keys.read_integer("tool", 0, kMaxTool, request.tool);
    keys.number("retract_mm", -kMaxPosition_mm, kMaxPosition_mm, request.retract_mm);
    keys.number("tolerance_mm", kMinTolerance_mm, kMaxTolerance_mm, request.format.tolerance_mm);
    keys.read_integer("decimals_mm", 1, kMaxDecimals, request.format.decimals_mm);
    keys.boolean("inch", request.format.inch);
    keys.boolean("verbose_words", request.format.verbose_words);
    keys.boolean("separate_files", request.format.separate_files);
    keys.boolean("go_on", request.format.continue_on_unknown);
    if (offsets) request.offsets = kOffsets[*offsets];
    return finish_keys(keys).map([&] { return std::move(request); });
}

/// Opens, reads and plans the path first, so that writing cannot fail.
tl::expected<engine::PathTranslation, engine::Error> planned(PathRequest request) {
    auto path = engine::PathTranslation::open(std::move(request));
    if (!path) return path;
    if (auto read = path->read(); !read) return tl::unexpected(read.error());
    if (auto planned = path->plan(); !planned) return tl::unexpected(planned.error());
    return path;
}

}  // namespace

VoidResult handle_write(const json& parameters, const engine::Request& request, const Post& post) {
    auto parsed_request = path_request(parameters);
    if (!parsed_request) return tl::unexpected(parsed_request.error());
    const auto machine = engine::Machine::read(request);
    if (!machine) return tl::unexpected(machine.error());
    parsed_request->machine = machine->machine_file();
    parsed_request->machine_data = machine->machine_data_file();
    parsed_request->host = request.host;
    const auto path = planned(*std::move(parsed_request));
    if (!path) return tl::unexpected(path.error());
    std::map<std::string, std::string> texts;  // by names of files, the main one's is empty
    auto written = path->write([&](const std::string& file) {
        return [&text = texts[file]](std::string_view part) {
            text += part;
            return true;
        };
    });
    if (!written) return written;
    const std::vector<std::string> names = path->file_names();
    Message message("program");
    message.header()["notes"] = path->notes();
    message.header()["files"] = names;
    message.add("text", texts[""]);
    for (std::size_t i = 0; i < names.size(); ++i)
        message.add(fmt::format("file{}", i).c_str(), texts[names[i]]);
    post(message.bytes());
    return {};
}

VoidResult handle_posts(const json& parameters, const engine::Request& /*request*/, const Post& post) {
    KeyReader keys(parameters, "posts");
    if (auto read = finish_keys(keys); !read) return read;
    Message message("posts");
    message.header()["names"] = engine::post_names();
    post(message.bytes());
    return {};
}

}  // namespace gsim::studio
