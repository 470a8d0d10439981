#include "apps/outputs.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "apps/to_error.h"

namespace gsim::apps {

using engine::OutputKind;
using os::OutputFile;

namespace {

/// "moves.left.jsonl"
std::string robot_file_name(const std::string& name, const std::string& robot) {
    std::filesystem::path path(name);
    path.replace_filename(path.stem().string() + "." + robot + path.extension().string());
    return path.string();
}

}  // namespace

std::span<const OutputNames::File> OutputNames::files() {
    static constexpr File kFiles[] = {
        {"--report", &OutputNames::report, std::nullopt},
        {"--view", &OutputNames::view, std::nullopt},
#define GSIM_DOCUMENT(name, number, option, help, ...) {option, &OutputNames::name, OutputKind::name},
#include "engine/outputs.def"
    };
    return kFiles;
}

bool OutputNames::any() const {
    return std::any_of(files().begin(), files().end(),
                       [this](const File& file) { return !(this->*file.name).empty(); });
}

bool OutputNames::on_standard_output() const {
    return std::any_of(files().begin(), files().end(),
                       [this](const File& file) { return this->*file.name == os::kStandardStream; });
}

std::optional<Error> OutputNames::conflict() const {
    if (plot == os::kStandardStream)
        return "--plot requires a file name, whose extension selects the type of picture";
    return std::nullopt;
}

OutputNames OutputNames::for_robot(const std::string& robot) const {
    OutputNames robot_names = *this;
    robot_names.report.clear();
    robot_names.view.clear();
    for (const File& file : files()) {
        std::string& name = robot_names.*file.name;
        if (!name.empty()) name = robot_file_name(name, robot);
    }
    return robot_names;
}

Result<OutputFile*> Outputs::add_file(const std::string& name) {
    return OutputFile::open(name).map([this](OutputFile file) {
        return files_.emplace_back(std::make_unique<OutputFile>(std::move(file))).get();
    });
}

Result<std::unique_ptr<Outputs>> Outputs::open(const OutputNames& names, engine::Run& run,
                                               std::size_t robot) {
    std::unique_ptr<Outputs> outputs(new Outputs(names));
    for (const OutputNames::File& file : OutputNames::files()) {
        const std::string& name = names.*file.name;
        if (name.empty()) continue;
        const auto ready =
            file.output_kind ? outputs->add(*file.output_kind, name, run, robot) : OutputFile::check(name);
        if (!ready) return tl::unexpected(ready.error());
    }
    return outputs;
}

Result<void> Outputs::add(OutputKind output_kind, const std::string& name, engine::Run& run,
                          std::size_t robot) {
    auto sink = open_sink(output_kind, name);
    if (!sink) return tl::unexpected(sink.error());
    engine::OutputOptions options = names_.options;
    options.name = name;
    options.bitmap = picture_ && picture_->bitmap();
    return run.write(output_kind, *std::move(sink), options, robot).map_error(to_error);
}

Result<engine::TextSink> Outputs::open_sink(OutputKind output_kind, const std::string& name) {
    if (output_kind == OutputKind::plot) {
        auto picture = engine::Picture::picture_for_file(name);
        if (!picture) return tl::unexpected(picture.error());
        picture_ = *std::move(picture);
        return [this](std::string_view text) {
            plot_script_ += text;
            return true;
        };
    }
    if (output_kind == OutputKind::path) {
        // The run may have no path, so the file is created only when the path exists.
        if (auto writable = OutputFile::check(name); !writable) return tl::unexpected(writable.error());
        return [this, name, file = static_cast<OutputFile*>(nullptr)](std::string_view text) mutable {
            if (file == nullptr && error_.empty()) {
                auto opened = add_file(name);
                if (!opened) error_ = opened.error().message;
                if (opened) file = *opened;
            }
            return file != nullptr && file->write(text);
        };
    }
    return add_file(name).map([](OutputFile* file) -> engine::TextSink {
        return [file](std::string_view text) { return file->write(text); };
    });
}

Result<void> Outputs::write_report(const engine::Report& report) {
    if (names_.report.empty()) return {};
    return add_file(names_.report).map([&](OutputFile* file) {
        file->write(report.json());
        file->write("\n");
    });
}

Result<void> Outputs::commit(const engine::Report& report) {
    if (!error_.empty()) return tl::unexpected(error_);
    if (auto written = write_report(report); !written) return written;
    for (const auto& file : files_) {
        if (auto flushed = file->prepare_commit(); !flushed) return flushed;
    }
    for (const auto& file : files_) {
        if (auto committed = file->commit(); !committed) return committed;
    }
    return picture_ ? picture_->draw(plot_script_) : Result<void>();
}

}  // namespace gsim::apps
