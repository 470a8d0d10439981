#include "engine/path_translation.h"

#include <filesystem>
#include <utility>

#include "codegen/post/post_file.h"
#include "engine/src/conversions.h"
#include "engine/src/guard_exceptions.h"
#include "engine/src/host_names.h"
#include "engine/src/machine/machine_input.h"
#include "engine/src/paths/path_changes.h"
#include "engine/src/paths/path_frames.h"
#include "engine/src/paths/path_input.h"
#include "engine/src/paths/path_points.h"
#include "engine/src/paths/path_program.h"

namespace gsim::engine {

using text::DiagnosticKind;

namespace {

constexpr const char* kPostExtension = ".toml";

Result<codegen::Post> read_post(const Host& host, const std::string& name) {
    if (!std::filesystem::path(name).has_extension()) return codegen::find_post(name);
    const auto file = resolve_name(host, NameKind::sample, name);
    if (!file) return tl::unexpected(file.error());
    if (!file->ends_with(kPostExtension)) return codegen::find_post(*file);
    return host.files.impl()
        .read_text(*file, os::NameSource::command_line)
        .and_then([&](const std::string& text) { return codegen::read_post(text, *file); });
}

// Uses those of the machine's settings, unless the request names others.
Result<void> read_data(const PathRequest& request, MachineInput& input) {
    if (request.machine_data.empty()) return {};
    const auto file = resolve_name(request.host, NameKind::sample, request.machine_data);
    if (!file) return tl::unexpected(file.error());
    return request.host.files.impl()
        .read_text(*file, os::NameSource::command_line)
        .and_then([&](const std::string& text) {
            return machine::read_machine_data(text, *file, input.machine.axes);
        })
        .map([&](machine::MachineData data) { input.data = std::move(data); });
}

PathProgramOptions make_options(const PathRequest& request, const path::Program& path) {
    PathProgramOptions options;
    options.words.inch = request.format.inch;
    options.words.verbose_words = request.format.verbose_words;
    options.words.decimals_mm = request.format.decimals_mm;
    options.rotary.is_literal = request.rotary_as_given.value_or(path.is_recorded());
    options.tolerance_mm = request.format.tolerance_mm;
    options.separate_files = request.format.separate_files;
    options.offsets = request.offsets;
    options.retract_mm = request.retract_mm;
    options.continue_on_unknown = request.format.continue_on_unknown;
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
          cpu_limit_(request_.cpu_s) {
        cpu_limit_.set_cancel_flag(request_.cancel.flag());
    }
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    const std::string& file() const { return file_; }
    const os::CpuLimit& cpu() const { return cpu_limit_; }
    const PathProgram& program() const { return *program_; }
    const std::vector<std::string>& notes() const { return notes_; }

    tl::expected<void, Error> read() {
        const script::LuaState::Limits limits{.memory_bytes =
                                                  static_cast<std::size_t>(request_.memory_bytes)};
        auto path = request_.bytes ? read_path_bytes(request_.bytes, file_)
                                   : read_path(request_.host.files.impl(), file_, limits, &cpu_limit_);
        if (!path) return tl::unexpected(path.error());
        path_ = *std::move(path);
        return {};
    }
    tl::expected<void, Error> plan() {
        if (auto completed = complete_frames(*path_, request_, post_); !completed)
            return tl::unexpected(path_error(completed.error()));
        const PointTables tables{machine_.machine, machine_.data ? &*machine_.data : nullptr, data_name()};
        auto notes = complete_points(*path_, tables, post_);
        if (!notes) return tl::unexpected(path_error(notes.error()));
        const PathContext context{machine_.machine, machine_.data ? &*machine_.data : nullptr, post_};
        if (auto changed = change_path(*path_, context, request_.changes); !changed)
            return tl::unexpected(path_error(changed.error()));
        auto program =
            PathProgram::plan(*path_, machine_.machine, post_, make_options(request_, path_->program));
        if (!program) return tl::unexpected(path_error(program.error()));
        notes_ = machine_.warnings;
        notes_.insert(notes_.end(), notes->begin(), notes->end());
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
    os::CpuLimit cpu_limit_;
    std::optional<path::PathFile> path_;
    std::optional<PathProgram> program_;
    std::vector<std::string> notes_;
};

tl::expected<PathTranslation, Error> PathTranslation::open(PathRequest request) {
    return guard_exceptions([&]() -> tl::expected<PathTranslation, Error> {
        const auto unexpected_error = [](const gsim::Error& error) {
            return tl::unexpected(make_error(DiagnosticKind::input_file, error));
        };
        auto post = read_post(request.host, request.post);
        if (!post) return unexpected_error(post.error());
        auto input = read_machine_input(request.host, request.machine, os::NameSource::command_line);
        if (!input) return unexpected_error(input.error());
        if (auto read = read_data(request, *input); !read) return unexpected_error(read.error());
        auto file = request.bytes ? Result<std::string>(request.path)
                                  : resolve_name(request.host, NameKind::sample, request.path);
        if (!file) return tl::unexpected(make_error(DiagnosticKind::file, file.error()));
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

tl::expected<void, Error> PathTranslation::read() {
    return guard_exceptions([&] { return state_->read(); });
}

double PathTranslation::cpu_left_s() const {
    return state_->cpu().remaining_s();
}

tl::expected<void, Error> PathTranslation::plan() {
    return guard_exceptions([&] { return state_->plan(); });
}

const std::vector<std::string>& PathTranslation::notes() const {
    return state_->notes();
}

std::vector<std::string> PathTranslation::file_names() const {
    return state_->program().file_names();
}

tl::expected<void, Error> PathTranslation::write(
    const std::function<TextSink(const std::string& file)>& open_sink) const {
    return guard_exceptions([&]() -> tl::expected<void, Error> {
        state_->program().write([&](const std::string& name) -> codegen::GcodeWriter::Sink {
            return [sink = open_sink(name), continues = true](std::string_view text) mutable {
                continues = continues && sink(text);
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
