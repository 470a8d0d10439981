#include "studio/server/folder_answers.h"

#include <charconv>
#include <cstdint>
#include <string>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "studio/server/guard.h"
#include "studio/server/json_answer.h"

namespace gsim::studio {

namespace {

using os::ContentTag;
using os::FolderFault;

constexpr std::size_t kMostFiles = WalkBounds{}.most_files;
constexpr std::size_t kLargestFile = kLargestBody;

constexpr int kNotFound = 404;
constexpr int kForbidden = 403;
constexpr int kConflict = 412;  // Precondition Failed
constexpr int kNeedsCondition = 428;
constexpr int kTooLarge = 413;
constexpr int kNoSpace = 507;
constexpr int kInternal = 500;

int status_of(FolderFault::Kind kind) {
    switch (kind) {
        case FolderFault::Kind::name: return kForbidden;
        case FolderFault::Kind::absent: return kNotFound;
        case FolderFault::Kind::conflict: return kConflict;
        case FolderFault::Kind::no_space: return kNoSpace;
        case FolderFault::Kind::other: break;
    }
    return kInternal;
}

void answer_fault(httplib::Response& response, const FolderFault& fault) {
    nlohmann::ordered_json answer{{"error", fault.sentence}};
    if (fault.kind == FolderFault::Kind::conflict)
        answer["tag"] = fault.tag.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(fault.tag);
    answer_json(response, status_of(fault.kind), answer);
}

/// Returns the version to replace, empty for a new file; no value if the request does not name it.
std::optional<ContentTag> version_of(const httplib::Request& request) {
    if (request.get_header_value("If-None-Match") == "*") return ContentTag();
    const std::string tag = request.get_header_value("If-Match");
    if (tag.size() < 3 || tag.front() != '"' || tag.back() != '"') return std::nullopt;
    return tag.substr(1, tag.size() - 2);
}

/// Returns the requested starting point, from the previous response; no value if it is no number.
std::optional<std::uint64_t> since_of(const httplib::Request& request) {
    const std::string text = request.get_param_value("since");
    std::uint64_t at = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), at);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(at) : std::nullopt;
}

}  // namespace

void FolderAnswers::list(httplib::Response& response) const {
    bool cut = false;
    nlohmann::ordered_json files = nlohmann::ordered_json::array();
    for (const os::FoundFile& file : folder_.list(kMostFiles, cut))
        files.push_back({{"name", file.name}, {"bytes", file.bytes}, {"tag", file.tag}});
    answer_json(response, 200, {{"files", std::move(files)}, {"cut", cut}});
}

void FolderAnswers::read(const std::string& name, httplib::Response& response) const {
    ContentTag tag;
    auto bytes = folder_.read(name, kLargestFile, &tag);
    if (!bytes) return answer_fault(response, bytes.error());
    response.set_header("ETag", fmt::format("\"{}\"", tag));
    response.set_content(*bytes, "application/octet-stream");
}

void FolderAnswers::write(const std::string& name, const httplib::Request& request,
                          httplib::Response& response, const httplib::ContentReader& content) const {
    const auto before = version_of(request);
    if (!before)
        return answer_error(response, kNeedsCondition,
                            "which version is replaced should stand in If-Match, or * in If-None-Match");
    std::size_t size = 0;
    const auto written = folder_.write(name, *before, [&](const os::BoundFolder::WritePiece& piece) {
        return content([&](const char* bytes, std::size_t count) {
            size += count;
            return size <= kLargestFile && piece({bytes, count});
        });
    });
    if (size > kLargestFile)
        return answer_error(response, kTooLarge,
                            fmt::format("'{}' is larger than {} MiB", name, kLargestFile >> 20U));
    if (!written) return answer_fault(response, written.error());
    answer_json(response, 200, {{"tag", *written}});
}

void FolderAnswers::changes(const httplib::Request& request, httplib::Response& response) {
    const ChangesAnswer answer = changes_.since(since_of(request));
    nlohmann::ordered_json changed = nlohmann::ordered_json::array();
    for (const FolderChange& change : answer.changes) {
        const auto tag = change.tag ? nlohmann::ordered_json(*change.tag) : nlohmann::ordered_json();
        changed.push_back({{"name", change.name}, {"tag", tag}});
    }
    answer_json(response, 200, {{"at", answer.at}, {"again", answer.again}, {"changed", std::move(changed)}});
}

}  // namespace gsim::studio
