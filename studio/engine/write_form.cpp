// Writes a path file as a part program.

#include <array>
#include <map>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "engine/machine.h"
#include "engine/path_translation.h"
#include "studio/engine/answer.h"
#include "studio/engine/keys.h"
#include "studio/engine/message.h"

namespace gsim::studio {

using engine::Offsets;
using engine::PathRequest;
using nlohmann::json;

namespace {

constexpr std::array kOffsetWords{"as_path", "keep", "none", "machine"};
constexpr std::array kOffsets{Offsets::as_path, Offsets::keep, Offsets::none, Offsets::machine};
static_assert(kOffsetWords.size() == kOffsets.size());

constexpr int kMostDecimals = 6;
constexpr int kGreatestTool = 99'999'999;
constexpr double kGreatestPlace_mm = 1e6;
constexpr double kLeastTolerance_mm = 1e-4;
constexpr double kGreatestTolerance_mm = 10;

tl::expected<PathRequest, engine::Failure> path_request(const json& own) {
    PathRequest request;
    request.post = "ab9";
    std::optional<std::size_t> offsets;
    Keys keys(own, "write");
    keys.needed_text("path", request.path);
    keys.text("post", request.post);
    keys.text("program_name", request.program_name);
    keys.truth("rotary_as_given", request.rotary_as_given);
    keys.word("offsets", kOffsetWords, offsets);
    keys.text("work_offset", request.work_offset);
    keys.point("set_offset_mm", -kGreatestPlace_mm, kGreatestPlace_mm, request.set_offset_mm);
    keys.whole("tool", 0, kGreatestTool, request.tool);
    keys.number("retract_mm", -kGreatestPlace_mm, kGreatestPlace_mm, request.retract_mm);
    keys.number("tolerance_mm", kLeastTolerance_mm, kGreatestTolerance_mm, request.tolerance_mm);
    keys.whole("decimals_mm", 1, kMostDecimals, request.decimals_mm);
    keys.truth("inch", request.inch);
    keys.truth("verbose_words", request.verbose_words);
    keys.truth("separate_files", request.separate_files);
    keys.truth("go_on", request.go_on);
    if (offsets) request.offsets = kOffsets[*offsets];
    return end_of(keys).map([&] { return std::move(request); });
}

/// Opens, reads and plans the path first, so that writing cannot fail.
tl::expected<engine::PathTranslation, engine::Failure> planned(PathRequest request) {
    auto path = engine::PathTranslation::open(std::move(request));
    if (!path) return path;
    if (auto read = path->read(); !read) return tl::unexpected(read.error());
    if (auto planned = path->plan(); !planned) return tl::unexpected(planned.error());
    return path;
}

}  // namespace

Done answer_write(const json& own, const engine::Request& request, const Post& post) {
    auto asked = path_request(own);
    if (!asked) return tl::unexpected(asked.error());
    const auto machine = engine::Machine::read(request);
    if (!machine) return tl::unexpected(machine.error());
    asked->machine = machine->machine_file();
    asked->machine_data = machine->machine_data_file();
    asked->host = request.host;
    const auto path = planned(*std::move(asked));
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

Done answer_posts(const json& own, const engine::Request& /*request*/, const Post& post) {
    Keys keys(own, "posts");
    if (auto read = end_of(keys); !read) return read;
    Message message("posts");
    message.header()["names"] = engine::post_names();
    post(message.bytes());
    return {};
}

}  // namespace gsim::studio
