#include "engine/path_translation.h"

#include <filesystem>
#include <utility>

#include "codegen/post/post_file.h"
#include "engine/src/guarded.h"
#include "engine/src/host_names.h"
#include "engine/src/machine/machine_input.h"
#include "engine/src/paths/path_changes.h"
#include "engine/src/paths/path_frames.h"
#include "engine/src/paths/path_input.h"
#include "engine/src/paths/path_points.h"
#include "engine/src/paths/path_program.h"
#include "engine/src/values.h"

namespace gsim::engine {

using text::DiagnosticKind;

namespace {

constexpr const char* kPostEnding = ".toml";

Failure fault_of_path(std::string sentence) {
    Failure failure = failure_of(DiagnosticKind::path, std::move(sentence));
    failure.in_program = true;
    return failure;
}

tl::expected<codegen::Post, std::string> read_post(const Host& host, const std::string& name) {
    if (!std::filesystem::path(name).has_extension()) return codegen::find_post(name);
    const auto file = find_name(host, NameKind::sample, name);
    if (!file) return tl::unexpected(file.error());
    if (!file->ends_with(kPostEnding)) return codegen::find_post(*file);
    return host.files.inner()
        .read_text(*file, os::NamedBy::command_line)
        .and_then([&](const std::string& text) { return codegen::read_post(text, *file); });
}

// Uses those of the machine's settings, unless the request names others.
tl::expected<void, std::string> read_data(const PathRequest& request, MachineInput& input) {
    if (request.machine_data.empty()) return {};
    const auto file = find_name(request.host, NameKind::sample, request.machine_data);
    if (!file) return tl::unexpected(file.error());
    return request.host.files.inner()
        .read_text(*file, os::NamedBy::command_line)
        .and_then([&](const std::string& text) {
            return machine::read_machine_data(text, *file, input.machine.axes);
        })
        .map([&](machine::MachineData data) { input.data = std::move(data); });
}

PathProgramOptions options_of(const PathRequest& request, const path::Program& path) {
    PathProgramOptions options;
    options.words.inch = request.inch;
    options.words.verbose_words = request.verbose_words;
    options.words.decimals_mm = request.decimals_mm;
    options.rotary.as_given = request.rotary_as_given.value_or(path.is_recorded());
    options.tolerance_mm = request.tolerance_mm;
    options.separate_files = request.separate_files;
    options.offsets = request.offsets;
    options.retract_mm = request.retract_mm;
    options.go_on = request.go_on;
    options.name = request.program_name.empty() ? path.name : request.program_name;
    return options;
}

}  // namespace

// The arguments of a PathProgram must keep their address.
class PathTranslation::State {
  public:
    State(PathRequest request, std::string file, codegen::Post post, MachineInput machine)
        : request_(std::move(request)),
          file_(std::move(file)),
          post_(std::move(post)),
          machine_(std::move(machine)),
          cpu_(request_.cpu_s) {
        cpu_.end_when(request_.cancel.flag());
    }
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    const std::string& file() const { return file_; }
    const os::CpuLimit& cpu() const { return cpu_; }
    const PathProgram& program() const { return *program_; }
    const std::vector<std::string>& notes() const { return notes_; }

    tl::expected<void, Failure> read() {
        const script::LuaState::Limits limits{.memory_bytes =
                                                  static_cast<std::size_t>(request_.memory_bytes)};
        auto path = request_.bytes ? read_path_bytes(request_.bytes, file_)
                                   : read_path(request_.host.files.inner(), file_, limits, &cpu_);
        if (!path && path.error().in_path) return tl::unexpected(fault_of_path(path.error().message));
        if (!path) return tl::unexpected(failure_of(DiagnosticKind::file, path.error().message));
        path_ = *std::move(path);
        return {};
    }
    tl::expected<void, Failure> plan() {
        if (auto completed = complete_frames(*path_, request_, post_); !completed)
            return tl::unexpected(fault_of_path(completed.error()));
        const PointTables tables{machine_.machine, machine_.data ? &*machine_.data : nullptr, data_name()};
        auto notes = complete_points(*path_, tables, post_);
        if (!notes) return tl::unexpected(fault_of_path(notes.error()));
        const PathSite site{machine_.machine, machine_.data ? &*machine_.data : nullptr, post_};
        if (auto changed = change_path(*path_, site, request_.changes); !changed)
            return tl::unexpected(fault_of_path(changed.error()));
        auto program =
            PathProgram::plan(*path_, machine_.machine, post_, options_of(request_, path_->program));
        if (!program) return tl::unexpected(fault_of_path(program.error()));
        notes_ = *std::move(notes);
        notes_.insert(notes_.end(), program->notes().begin(), program->notes().end());
        program_.emplace(*std::move(program));
        return {};
    }

  private:
    const std::string& data_name() const {
        return request_.machine_data.empty() ? request_.machine : request_.machine_data;
    }

    PathRequest request_;
    std::string file_;
    codegen::Post post_;
    MachineInput machine_;
    os::CpuLimit cpu_;
    std::optional<path::PathFile> path_;
    std::optional<PathProgram> program_;
    std::vector<std::string> notes_;
};

tl::expected<PathTranslation, Failure> PathTranslation::open(PathRequest request) {
    return guarded([&]() -> tl::expected<PathTranslation, Failure> {
        const auto refused = [](const std::string& sentence) {
            return tl::unexpected(failure_of(DiagnosticKind::input_file, sentence));
        };
        auto post = read_post(request.host, request.post);
        if (!post) return refused(post.error());
        auto input = read_machine_input(request.host, request.machine, os::NamedBy::command_line);
        if (!input) return refused(input.error());
        if (auto read = read_data(request, *input); !read) return refused(read.error());
        auto file = request.bytes ? tl::expected<std::string, std::string>(request.path)
                                  : find_name(request.host, NameKind::sample, request.path);
        if (!file) return tl::unexpected(failure_of(DiagnosticKind::file, file.error()));
        return PathTranslation(std::make_unique<State>(std::move(request), *std::move(file), *std::move(post),
                                                       std::move(*input)));
    });
}

PathTranslation::PathTranslation(std::unique_ptr<State> state) : state_(std::move(state)) {}
PathTranslation::PathTranslation(PathTranslation&&) noexcept = default;
PathTranslation& PathTranslation::operator=(PathTranslation&&) noexcept = default;
PathTranslation::~PathTranslation() = default;

const std::string& PathTranslation::path_file() const {
    return state_->file();
}

tl::expected<void, Failure> PathTranslation::read() {
    return guarded([&] { return state_->read(); });
}

double PathTranslation::cpu_left_s() const {
    return state_->cpu().left_s();
}

tl::expected<void, Failure> PathTranslation::plan() {
    return guarded([&] { return state_->plan(); });
}

const std::vector<std::string>& PathTranslation::notes() const {
    return state_->notes();
}

std::vector<std::string> PathTranslation::file_names() const {
    return state_->program().file_names();
}

tl::expected<void, Failure> PathTranslation::write(
    const std::function<TextSink(const std::string& file)>& sink_of) const {
    return guarded([&]() -> tl::expected<void, Failure> {
        state_->program().write([&](const std::string& name) -> codegen::GcodeWriter::Sink {
            return [sink = sink_of(name), goes_on = true](std::string_view text) mutable {
                goes_on = goes_on && sink(text);
            };
        });
        return {};
    });
}

std::vector<std::string> post_names() {
    const std::vector<std::string_view> names = codegen::built_in_posts();
    return {names.begin(), names.end()};
}

}  // namespace gsim::engine
