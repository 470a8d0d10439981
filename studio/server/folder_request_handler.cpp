#include "studio/server/folder_request_handler.h"

#include <charconv>
#include <cstdint>
#include <string>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "studio/server/access_check.h"
#include "studio/server/json_response.h"

namespace gsim::studio {

namespace {

using os::ContentTag;
using os::DirectoryError;

constexpr std::size_t kMaxFiles = ScanLimits{}.max_files;
constexpr std::size_t kMaxFileBytes = kMaxBodyBytes;

constexpr int kNotFound = 404;
constexpr int kForbidden = 403;
constexpr int kPreconditionFailed = 412;  // Precondition Failed
constexpr int kPreconditionRequired = 428;
constexpr int kContentTooLarge = 413;
constexpr int kInsufficientStorage = 507;
constexpr int kInternalServerError = 500;

int http_status(DirectoryError::Kind kind) {
    switch (kind) {
        case DirectoryError::Kind::name: return kForbidden;
        case DirectoryError::Kind::absent: return kNotFound;
        case DirectoryError::Kind::conflict: return kPreconditionFailed;
        case DirectoryError::Kind::no_space: return kInsufficientStorage;
        case DirectoryError::Kind::other: break;
    }
    return kInternalServerError;
}

void respond_with_error(httplib::Response& response, const DirectoryError& error) {
    nlohmann::ordered_json body{{"error", error.message}};
    if (error.kind == DirectoryError::Kind::conflict)
        body["tag"] = error.tag.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(error.tag);
    respond_json(response, http_status(error.kind), body);
}

/// Returns the version to replace, empty for a new file; no value if the request does not name it.
std::optional<ContentTag> required_version(const httplib::Request& request) {
    if (request.get_header_value("If-None-Match") == "*") return ContentTag();
    const std::string tag = request.get_header_value("If-Match");
    if (tag.size() < 3 || tag.front() != '"' || tag.back() != '"') return std::nullopt;
    return tag.substr(1, tag.size() - 2);
}

/// Returns the requested starting point, from the previous response; no value if it is no number.
std::optional<std::uint64_t> requested_since(const httplib::Request& request) {
    const std::string text = request.get_param_value("since");
    std::uint64_t at = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), at);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(at) : std::nullopt;
}

}  // namespace

void FolderRequestHandler::list(httplib::Response& response) const {
    bool cut = false;
    nlohmann::ordered_json files = nlohmann::ordered_json::array();
    for (const os::FileEntry& file : folder_.list(kMaxFiles, cut))
        files.push_back({{"name", file.name}, {"bytes", file.bytes}, {"tag", file.tag}});
    respond_json(response, 200, {{"files", std::move(files)}, {"cut", cut}});
}

void FolderRequestHandler::read(const std::string& name, httplib::Response& response) const {
    ContentTag tag;
    auto bytes = folder_.read(name, kMaxFileBytes, &tag);
    if (!bytes) return respond_with_error(response, bytes.error());
    response.set_header("ETag", fmt::format("\"{}\"", tag));
    response.set_content(*bytes, "application/octet-stream");
}

void FolderRequestHandler::write(const std::string& name, const httplib::Request& request,
                                 httplib::Response& response, const httplib::ContentReader& content) const {
    const auto before = required_version(request);
    if (!before)
        return respond_error(response, kPreconditionRequired,
                             "If-Match must contain the version to replace, or If-None-Match must be *");
    std::size_t size = 0;
    const auto written = folder_.write(name, *before, [&](const os::RootedDirectory::WriteChunk& chunk) {
        return content([&](const char* bytes, std::size_t count) {
            size += count;
            return size <= kMaxFileBytes && chunk({bytes, count});
        });
    });
    if (size > kMaxFileBytes)
        return respond_error(response, kContentTooLarge,
                             fmt::format("'{}' is larger than {} MiB", name, kMaxFileBytes >> 20U));
    if (!written) return respond_with_error(response, written.error());
    respond_json(response, 200, {{"tag", *written}});
}

void FolderRequestHandler::changes(const httplib::Request& request, httplib::Response& response) {
    const FolderChangesResult body = changes_.since(requested_since(request));
    nlohmann::ordered_json changed = nlohmann::ordered_json::array();
    for (const FolderChange& change : body.changes) {
        const auto tag = change.tag ? nlohmann::ordered_json(*change.tag) : nlohmann::ordered_json();
        changed.push_back({{"name", change.name}, {"tag", tag}});
    }
    respond_json(response, 200,
                 {{"at", body.at}, {"again", body.is_incomplete}, {"changed", std::move(changed)}});
}

}  // namespace gsim::studio
