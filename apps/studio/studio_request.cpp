#include "apps/studio/studio_request.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <sys/prctl.h>

#include "apps/confine_run.h"
#include "base/os/file_handle.h"
#include "base/os/installation.h"
#include "base/os/rooted_directory.h"
#include "base/text/base64.h"
#include "base/text/json.h"
#include "cli/exit_status.h"
#include "cli/usage_error.h"
#include "engine/system/parts_host.h"
#include "studio/engine/compact_message.h"
#include "studio/engine/session.h"

namespace gsim::apps {

namespace {

namespace fs = std::filesystem;
using engine::NameKind;

constexpr const char* kName = "gsim studio-answer";
constexpr std::size_t kMaxFileBytes = std::size_t{2} << 30U;
constexpr std::size_t kChunkBytes = std::size_t{1} << 20U;
constexpr std::string_view kSamples = "samples/";

/// Files by the page's names for them, searched in this order: files of the page, the folder, the samples.
class ServedFiles {
  public:
    explicit ServedFiles(os::RootedDirectory folder) : folder_(std::move(folder)) {
        for (const fs::path& data : os::data_folders(os::program_folder())) {
            std::error_code ignored;
            const fs::path samples = fs::canonical(data / "samples", ignored);  // a build folder has a link
            if (auto bound = os::RootedDirectory::open(samples)) samples_.push_back(*std::move(bound));
        }
    }

    void add(const std::string& name, std::string bytes) { page_files_[name] = std::move(bytes); }

    std::optional<std::string> read(const std::string& name) const {
        if (const auto given = page_files_.find(name); given != page_files_.end()) return given->second;
        if (auto bytes = folder_.read(name, kMaxFileBytes)) return *std::move(bytes);
        if (name.rfind(kSamples, 0) != 0) return std::nullopt;
        for (const os::RootedDirectory& samples : samples_) {
            if (auto bytes = samples.read(name.substr(kSamples.size()), kMaxFileBytes))
                return *std::move(bytes);
        }
        return std::nullopt;
    }

    /// Returns the file on the disk, for programs that read it themselves; empty if it does not exist.
    std::optional<std::string> disk_path(const std::string& name) const {
        if (page_files_.count(name) == 0 && folder_.content_tag(name))
            return (folder_.path() / name).string();
        if (name.rfind(kSamples, 0) != 0) return std::nullopt;
        const std::string relative_name = name.substr(kSamples.size());
        for (const os::RootedDirectory& samples : samples_) {
            if (samples.content_tag(relative_name)) return (samples.path() / relative_name).string();
        }
        return std::nullopt;
    }

    /// Returns the folders that may be read.
    std::vector<fs::path> folders() const {
        std::vector<fs::path> all{folder_.path()};
        for (const os::RootedDirectory& samples : samples_) all.push_back(samples.path());
        return all;
    }

  private:
    os::RootedDirectory folder_;
    std::vector<os::RootedDirectory> samples_;
    std::map<std::string, std::string> page_files_;
};

std::string read_all(std::FILE* stream) {
    std::string text;
    for (std::size_t size = 0;;) {
        text.resize(size + kChunkBytes);
        const std::size_t bytes_read = std::fread(text.data() + size, 1, kChunkBytes, stream);
        size += bytes_read;
        if (bytes_read == 0) {
            text.resize(size);
            return text;
        }
    }
}

/// Returns the value of an option; empty: it is not given.
std::string option_value(std::span<const std::string> arguments, std::string_view option) {
    for (std::size_t i = 0; i + 1 < arguments.size(); ++i) {
        if (arguments[i] == option) return arguments[i + 1];
    }
    return {};
}

engine::Host make_host(const std::shared_ptr<const ServedFiles>& files, const std::string& module) {
    engine::Host host = engine::make_parts_host();
    host.files = engine::Files::given([files](const std::string& name) { return files->read(name); });
    host.find = [files](NameKind kind, const std::string& name) -> tl::expected<std::string, std::string> {
        const std::string machine = "samples/machines/" + name + ".toml";
        const bool is_machine_name = kind == NameKind::machine && !name.empty() && !files->read(name);
        return is_machine_name && files->read(machine) ? machine : name;
    };
    const auto disk_path = [files](const std::string& name) -> tl::expected<std::string, std::string> {
        if (auto file = files->disk_path(name)) return *file;
        return tl::unexpected("'" + name + "' must be read from the disk: save it to the folder first");
    };
    host.read_solid = [read = host.read_solid, disk_path](const std::string& file, double tolerance_mm) {
        return disk_path(file).and_then([&](const std::string& name) { return read(name, tolerance_mm); });
    };
    host.read_plate = [read = host.read_plate, disk_path](const std::string& file,
                                                          const engine::PlateReadOptions& options) {
        return disk_path(file).and_then([&](const std::string& name) { return read(name, options); });
    };
    host.read_contours = [read = host.read_contours, disk_path](const std::string& file,
                                                                const engine::ContourSelection& options) {
        return disk_path(file).and_then([&](const std::string& name) { return read(name, options); });
    };
    host.load_module =
        [load = host.load_module, module](
            const std::string& file,
            const machine::Machine& machine) -> tl::expected<std::shared_ptr<rrs::RcsModule>, std::string> {
        if (file != module || module.empty())
            return tl::unexpected(
                std::string("the controller module is not the one given to gsim studio (--rcs)"));
        return load(file, machine);
    };
    return host;
}

bool add_files(const nlohmann::json& input_json, ServedFiles& files) {
    const auto texts = input_json.value("files", nlohmann::json::object());
    for (const auto& [name, text] : texts.items()) {
        if (!text.is_string()) return false;
        files.add(name, text.get<std::string>());
    }
    const auto others = input_json.value("binary", nlohmann::json::object());
    for (const auto& [name, compressed] : others.items()) {
        auto bytes =
            compressed.is_string() ? text::decode_base64(compressed.get<std::string>()) : std::nullopt;
        if (!bytes) return false;
        files.add(name, *std::move(bytes));
    }
    return true;
}

void write_message(std::string_view bytes) {
    std::fwrite(bytes.data(), 1, bytes.size(), stdout);
    std::fflush(stdout);
}

/// Storage of complete segment messages in the file that is open as descriptor 3. Past the first segments,
/// the page gets messages without the data that it can request later.
class SegmentArchive {
  public:
    explicit SegmentArchive(std::uint64_t full_segments)
        : full_segments_(full_segments), file_(::fdopen(kArchiveDescriptor, "wb")) {
        if (!file_) throw std::system_error(errno, std::generic_category(), "the run cannot be stored");
    }
    void post(const std::string& message) const {
        const auto first = studio::first_segment(message);
        if (first) store(message);
        write_message(first && *first >= full_segments_ ? *studio::compact_message(message) : message);
    }

  private:
    static constexpr int kArchiveDescriptor = 3;
    void store(const std::string& message) const {
        if (std::fwrite(message.data(), 1, message.size(), file_.get()) != message.size() ||
            std::fflush(file_.get()) != 0)
            throw std::system_error(errno, std::generic_category(), "the run cannot be stored");
    }

    std::uint64_t full_segments_;
    os::FileHandle file_;
};

/// Returns the message sink. "--keep-behind N": runs are kept, and pages get the first N segments complete;
/// "" selects the default number.
studio::Post message_sink(std::span<const std::string> arguments) {
    constexpr std::uint64_t kFullSegments = 1'000'000;
    const auto option = std::find(arguments.begin(), arguments.end(), "--keep-behind");
    if (option == arguments.end() || option + 1 == arguments.end()) return write_message;
    std::uint64_t full_segments = kFullSegments;
    std::from_chars((option + 1)->data(), (option + 1)->data() + (option + 1)->size(), full_segments);
    return [archive = std::make_shared<const SegmentArchive>(full_segments)](const std::string& message) {
        archive->post(message);
    };
}

/// Confines the process before anything that a page has sent is read.
Result<void> confine(const ServedFiles& files, const std::string& module) {
    if (!module.empty()) return {};  // its code may reach what it likes
    return confine_to_folders(files.folders());
}

}  // namespace

int handle_studio_request(std::span<const std::string> arguments) {
    std::signal(SIGPIPE, SIG_DFL);
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // the requester has exited
    auto folder = os::RootedDirectory::open(option_value(arguments, "--folder"));
    if (!folder) return usage_error(kName, folder.error().message);
    const std::string module = option_value(arguments, "--rcs");
    const auto files = std::make_shared<ServedFiles>(*std::move(folder));
    if (auto confined = confine(*files, module); !confined)
        return usage_error(kName, confined.error().message);
    const studio::Post post = message_sink(arguments);
    const auto input_json = text::try_parse_json<nlohmann::json>(read_all(stdin));
    if (!input_json.is_object() || !input_json.contains("request") || !add_files(input_json, *files)) {
        studio::handle_request("", {}, post);  // says what a request should be
        return kSuccess;
    }
    nlohmann::json request = input_json["request"];
    if (!module.empty() && request.is_object() && request.value("do", "") == "run")
        request["module"] = module;
    studio::handle_request(request.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace),
                           make_host(files, module), post);
    return kSuccess;
}

}  // namespace gsim::apps
