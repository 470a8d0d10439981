#include "batch/pages/views.h"

#include <algorithm>
#include <cstdio>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "base/os/child_process.h"
#include "base/os/file_handle.h"
#include "batch/pages/site.h"
#include "batch/work/run_commands.h"
#include "batch/work/sha256.h"

namespace gsim::batch {

namespace {

namespace fs = std::filesystem;

constexpr const char* kFolder = "views";
constexpr std::string_view kTitle = "<title>gsim studio</title>";
constexpr std::string_view kPrefix = "run-", kExtension = ".html";
constexpr std::size_t kDigits = 16;
constexpr std::int64_t kMaxMoves = 200'000;  // a page of so many has some 10 MB

/// Builds the name from all inputs that determine the run, so another run never has the same name.
std::string view_name(const RunDetails& run) {
    std::string all = run.key;
    for (const ReadFile& file : run.files) all += '\0' + file.name + '\0' + file.sha256;
    return fmt::format("{}{}{}", kPrefix, sha256(all).substr(0, kDigits), kExtension);
}

bool is_view_name(std::string_view name) {
    if (name.size() != kPrefix.size() + kDigits + kExtension.size() || !name.starts_with(kPrefix) ||
        !name.ends_with(kExtension))
        return false;
    const std::string_view digits = name.substr(kPrefix.size(), kDigits);
    return digits.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

/// Returns false for a program that was refused, or that crashed its process: it has no run to show.
bool has_run(const RunSummary& facts) {
    return facts.has_time() || facts.status == "alarm" || facts.status == "stopped";
}

}  // namespace

Views::Views(const std::string& folder, ViewGenerator maker)
    : folder_(fs::path(folder) / kFolder), generator_(std::move(maker)) {}

Result<std::vector<std::string>> Views::make_command(const RunSummary& facts, const RunDetails& run) {
    if (!has_run(facts)) return Unexpected("the program was not run");
    if (run.counts.moves > kMaxMoves) return Unexpected(fmt::format("it has more than {} moves", kMaxMoves));
    if (run.version != generator_.version) return Unexpected("it was run by another version of gsim");
    ViewCommand command = view_command(run_inputs(run));
    if (command.words.empty()) return Unexpected("its program is a path, which gsim run does not support");
    if (!command.left_out.empty())
        return Unexpected(fmt::format("gsim run has no option for {}", command.left_out.front()));
    const auto other = std::find_if(run.files.begin(), run.files.end(), [&](const ReadFile& file) {
        return files_.file_hash(file.name) != file.sha256;
    });
    if (other != run.files.end())
        return Unexpected(fmt::format("'{}' has changed since the run", other->name));
    command.words.front() = generator_.program;
    return std::move(command.words);
}

Result<std::string> Views::make(const RunSummary& facts, const RunDetails& run) {
    const std::string name = view_name(run);
    const fs::path file = folder_ / name;
    const auto view_address = [&] {
        names_.insert(name);
        return fmt::format("{}/{}", kFolder, name);
    };
    std::error_code error;
    if (fs::exists(file, error)) return view_address();
    auto words = make_command(facts, run);
    if (!words) return Unexpected(words.error());
    fs::create_directories(folder_, error);
    *std::find(words->begin(), words->end(), kViewFile) = file.string();
    const os::FileHandle null_device(std::fopen("/dev/null", "r+e"));
    if (!null_device) return Unexpected("/dev/null cannot be opened");
    const auto ended = os::run_child(*words, null_device.get(), null_device.get());
    // If the program has an error, its page is written as well.
    if (fs::exists(file, error)) return view_address();
    return Unexpected(ended ? "gsim run wrote no page" : ended.error().message);
}

Result<void> remove_views(const std::string& folder, const Views* current) {
    return remove_files(fs::path(folder) / kFolder, [&](const std::string& name, std::string_view head) {
        return is_view_name(name) && head.find(kTitle) != std::string_view::npos &&
               (current == nullptr || !current->names_.contains(name));
    });
}

}  // namespace gsim::batch
