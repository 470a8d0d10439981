#include "apps/studio/studio_answer.h"

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
#include "base/os/bound_folder.h"
#include "base/os/file_handle.h"
#include "base/os/installation.h"
#include "base/text/base64.h"
#include "base/text/json.h"
#include "cli/exit_status.h"
#include "cli/usage_error.h"
#include "engine/system/host_of_parts.h"
#include "studio/engine/lean_message.h"
#include "studio/engine/session.h"

namespace gsim::apps {

namespace {

namespace fs = std::filesystem;
using engine::NameKind;

constexpr const char* kName = "gsim studio-answer";
constexpr std::size_t kLargestFile = std::size_t{2} << 30U;
constexpr std::size_t kPiece = std::size_t{1} << 20U;
constexpr std::string_view kSamples = "samples/";

/// Files by the page's names for them, searched in this order: files of the page, the folder, the samples.
class ServedFiles {
  public:
    explicit ServedFiles(os::BoundFolder folder) : folder_(std::move(folder)) {
        for (const fs::path& data : os::data_folders(os::program_folder())) {
            std::error_code ignored;
            const fs::path samples = fs::canonical(data / "samples", ignored);  // a build folder has a link
            if (auto bound = os::BoundFolder::open(samples)) samples_.push_back(*std::move(bound));
        }
    }

    void put(const std::string& name, std::string bytes) { given_[name] = std::move(bytes); }

    std::optional<std::string> read(const std::string& name) const {
        if (const auto given = given_.find(name); given != given_.end()) return given->second;
        if (auto bytes = folder_.read(name, kLargestFile)) return *std::move(bytes);
        if (name.rfind(kSamples, 0) != 0) return std::nullopt;
        for (const os::BoundFolder& samples : samples_) {
            if (auto bytes = samples.read(name.substr(kSamples.size()), kLargestFile))
                return *std::move(bytes);
        }
        return std::nullopt;
    }

    /// Returns the file on the disk, for programs that read it themselves; empty if it does not exist.
    std::optional<std::string> on_disk(const std::string& name) const {
        if (given_.count(name) == 0 && folder_.tag_of(name)) return (folder_.path() / name).string();
        if (name.rfind(kSamples, 0) != 0) return std::nullopt;
        const std::string below = name.substr(kSamples.size());
        for (const os::BoundFolder& samples : samples_) {
            if (samples.tag_of(below)) return (samples.path() / below).string();
        }
        return std::nullopt;
    }

    /// Returns the folders that may be read.
    std::vector<fs::path> folders() const {
        std::vector<fs::path> all{folder_.path()};
        for (const os::BoundFolder& samples : samples_) all.push_back(samples.path());
        return all;
    }

  private:
    os::BoundFolder folder_;
    std::vector<os::BoundFolder> samples_;
    std::map<std::string, std::string> given_;
};

std::string all_of(std::FILE* stream) {
    std::string text;
    for (std::size_t size = 0;;) {
        text.resize(size + kPiece);
        const std::size_t got = std::fread(text.data() + size, 1, kPiece, stream);
        size += got;
        if (got == 0) {
            text.resize(size);
            return text;
        }
    }
}

/// Returns the value of an option; empty: it is not given.
std::string value_of(std::span<const std::string> arguments, std::string_view option) {
    for (std::size_t i = 0; i + 1 < arguments.size(); ++i) {
        if (arguments[i] == option) return arguments[i + 1];
    }
    return {};
}

engine::Host host_of(const std::shared_ptr<const ServedFiles>& files, const std::string& module) {
    engine::Host host = engine::host_of_parts();
    host.files = engine::Files::given([files](const std::string& name) { return files->read(name); });
    host.find = [files](NameKind kind, const std::string& name) -> tl::expected<std::string, std::string> {
        const std::string machine = "samples/machines/" + name + ".toml";
        const bool is_short = kind == NameKind::machine && !name.empty() && !files->read(name);
        return is_short && files->read(machine) ? machine : name;
    };
    const auto on_disk = [files](const std::string& name) -> tl::expected<std::string, std::string> {
        if (auto file = files->on_disk(name)) return *file;
        return tl::unexpected("'" + name + "' is read from the disk: save it into the folder first");
    };
    host.read_solid = [read = host.read_solid, on_disk](const std::string& file, double tolerance_mm) {
        return on_disk(file).and_then([&](const std::string& name) { return read(name, tolerance_mm); });
    };
    host.read_plate = [read = host.read_plate, on_disk](const std::string& file,
                                                        const engine::PlateChoice& choice) {
        return on_disk(file).and_then([&](const std::string& name) { return read(name, choice); });
    };
    host.read_contours = [read = host.read_contours, on_disk](const std::string& file,
                                                              const engine::ContourChoice& choice) {
        return on_disk(file).and_then([&](const std::string& name) { return read(name, choice); });
    };
    host.load_module =
        [load = host.load_module, module](
            const std::string& file,
            const machine::Machine& machine) -> tl::expected<std::shared_ptr<rrs::RcsModule>, std::string> {
        if (file != module || module.empty())
            return tl::unexpected(
                std::string("the controller module is not the one that gsim studio was begun with (--rcs)"));
        return load(file, machine);
    };
    return host;
}

bool take_files(const nlohmann::json& asked, ServedFiles& files) {
    const auto texts = asked.value("files", nlohmann::json::object());
    for (const auto& [name, text] : texts.items()) {
        if (!text.is_string()) return false;
        files.put(name, text.get<std::string>());
    }
    const auto others = asked.value("binary", nlohmann::json::object());
    for (const auto& [name, packed] : others.items()) {
        auto bytes = packed.is_string() ? text::bytes_of_base64(packed.get<std::string>()) : std::nullopt;
        if (!bytes) return false;
        files.put(name, *std::move(bytes));
    }
    return true;
}

void write_message(std::string_view bytes) {
    std::fwrite(bytes.data(), 1, bytes.size(), stdout);
    std::fflush(stdout);
}

/// Storage of complete segment messages in the file that is open as descriptor 3. After the first segments
/// the page gets messages without the data that it can request later.
class Keeping {
  public:
    explicit Keeping(std::uint64_t whole) : whole_(whole), file_(::fdopen(kKept, "wb")) {
        if (!file_) throw std::system_error(errno, std::generic_category(), "the run cannot be kept");
    }
    void post(const std::string& message) const {
        const auto first = studio::first_segment(message);
        if (first) keep(message);
        write_message(first && *first >= whole_ ? *studio::lean_message(message) : message);
    }

  private:
    static constexpr int kKept = 3;
    void keep(const std::string& message) const {
        if (std::fwrite(message.data(), 1, message.size(), file_.get()) != message.size() ||
            std::fflush(file_.get()) != 0)
            throw std::system_error(errno, std::generic_category(), "the run cannot be kept");
    }

    std::uint64_t whole_;
    os::FileHandle file_;
};

/// Returns the message sink. "--keep-behind N": runs are kept, and pages get the first N segments complete;
/// "" selects the default number.
studio::Post post_of(std::span<const std::string> arguments) {
    constexpr std::uint64_t kWhole = 1'000'000;
    const auto option = std::find(arguments.begin(), arguments.end(), "--keep-behind");
    if (option == arguments.end() || option + 1 == arguments.end()) return write_message;
    std::uint64_t whole = kWhole;
    std::from_chars((option + 1)->data(), (option + 1)->data() + (option + 1)->size(), whole);
    return [keeping = std::make_shared<const Keeping>(whole)](const std::string& message) {
        keeping->post(message);
    };
}

/// Confines the process before anything that a page has sent is read.
tl::expected<void, std::string> confine(const ServedFiles& files, const std::string& module) {
    if (!module.empty()) return {};  // its code may reach what it likes
    return confine_to_folders(files.folders());
}

}  // namespace

int answer_studio(std::span<const std::string> arguments) {
    std::signal(SIGPIPE, SIG_DFL);
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // the requester has exited
    auto folder = os::BoundFolder::open(value_of(arguments, "--folder"));
    if (!folder) return usage_error(kName, folder.error());
    const std::string module = value_of(arguments, "--rcs");
    const auto files = std::make_shared<ServedFiles>(*std::move(folder));
    if (auto confined = confine(*files, module); !confined) return usage_error(kName, confined.error());
    const studio::Post post = post_of(arguments);
    const auto asked = text::try_parse_json<nlohmann::json>(all_of(stdin));
    if (!asked.is_object() || !asked.contains("request") || !take_files(asked, *files)) {
        studio::serve("", {}, post);  // says what a request should be
        return kDone;
    }
    nlohmann::json request = asked["request"];
    if (!module.empty() && request.is_object() && request.value("do", "") == "run")
        request["module"] = module;
    studio::serve(request.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace),
                  host_of(files, module), post);
    return kDone;
}

}  // namespace gsim::apps
