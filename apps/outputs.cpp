#include "apps/outputs.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include <fmt/format.h>

#include "runtime/path/json_writer.h"
#include "runtime/simulation/plot.h"
#include "runtime/simulation/report.h"

namespace gsim::apps {

using os::OutputFile;

namespace {

bool is_standard(const std::string& name) {
    return name == os::kStandardStream;
}

}  // namespace

std::span<const OutputNames::File> OutputNames::files() {
    static constexpr std::array kFiles = {
        File{"--report", &OutputNames::report}, File{"--moves", &OutputNames::moves},
        File{"--trajectory", &OutputNames::trajectory}, File{"--plot", &OutputNames::plot},
        File{"--record", &OutputNames::record}};
    return kFiles;
}

bool OutputNames::any() const {
    return std::any_of(files().begin(), files().end(),
                       [this](const File& file) { return !(this->*file.name).empty(); });
}

bool OutputNames::on_standard_output() const {
    return std::any_of(files().begin(), files().end(),
                       [this](const File& file) { return is_standard(this->*file.name); });
}

std::optional<std::string> OutputNames::conflict() const {
    if (is_standard(plot))
        return "--plot needs the name of a file, whose ending says which kind of picture it is";
    return std::nullopt;
}

tl::expected<Outputs::TextFile*, std::string> Outputs::add_file(const std::string& name) {
    tl::expected<OutputFile, std::string> file = OutputFile::open(name);
    if (!file) return tl::unexpected(file.error());
    files_.push_back(std::make_unique<TextFile>(std::move(*file)));
    return files_.back().get();
}

tl::expected<Outputs, std::string> Outputs::open(const OutputNames& names, simulation::Simulator& simulator) {
    Outputs outputs;
    outputs.names_ = names;
    if (!names.moves.empty()) {
        const auto file = outputs.add_file(names.moves);
        if (!file) return tl::unexpected(file.error());
        outputs.moves_ =
            std::make_unique<simulation::MovesWriter>((*file)->text, simulator.machine(), simulator.files());
        simulator.add_output(*outputs.moves_);
    }
    if (!names.trajectory.empty()) {
        const auto file = outputs.add_file(names.trajectory);
        if (!file) return tl::unexpected(file.error());
        outputs.trajectory_ = std::make_unique<simulation::TrajectoryWriter>(
            (*file)->text, simulator.machine(), names.step_s, simulator.max_time_s());
        simulator.add_output(*outputs.trajectory_);
    }
    for (const std::string* late : {&names.report, &names.record}) {
        if (late->empty()) continue;
        if (auto writable = OutputFile::check(*late); !writable) return tl::unexpected(writable.error());
    }
    if (auto plot = outputs.add_plot(simulator); !plot) return tl::unexpected(plot.error());
    if (!names.record.empty()) {
        outputs.recorder_ = std::make_unique<record::PathRecorder>(simulator.machine());
        simulator.set_observer(*outputs.recorder_);
    }
    if (names.explain) outputs.add_explanation(simulator);
    return outputs;
}

tl::expected<void, std::string> Outputs::add_plot(simulation::Simulator& simulator) {
    if (names_.plot.empty()) return {};
    const Plane plane = names_.plot_plane == "zx"   ? Plane::zx
                        : names_.plot_plane == "yz" ? Plane::yz
                                                    : Plane::xy;
    if (auto lacks = simulation::PlotData::lacks_axes(simulator.machine(), plane))
        return tl::unexpected(*lacks);
    auto picture = simulation::Picture::named(names_.plot);
    if (!picture) return tl::unexpected(picture.error());
    picture_ = *std::move(picture);
    plot_ = std::make_unique<simulation::PlotData>(simulator.machine(), plane);
    simulator.add_output(*plot_);
    return {};
}

tl::expected<void, std::string> Outputs::draw(const simulation::Report& report) {
    if (!picture_) return {};
    if (report.cell) {
        for (const simulation::Collision& collision : report.cell->collisions)
            plot_->mark_collision(collision.joints);
    }
    if (report.status == simulation::RunStatus::alarm) plot_->mark_alarm();
    return picture_->draw(*plot_, report.program);
}

void Outputs::add_explanation(simulation::Simulator& simulator) {
    causes_ = std::make_unique<Causes>(simulator.machine());
    simulator.add_output(causes_->times);
    if (simulator.sampled()) return;
    simulator.add_output(causes_->bound.emplace(simulator.machine()));
}

void Outputs::explain(simulation::Report& report) const {
    if (recorder_ != nullptr) {
        const std::set<std::string>& notes = recorder_->notes();
        report.warnings.insert(report.warnings.end(), notes.begin(), notes.end());
    }
    if (causes_ == nullptr) return;
    std::optional<double> bound_s;
    if (causes_->bound) bound_s = causes_->bound->bound_s();
    report.explanation = simulation::Explanation{causes_->times.list(causes_->machine), bound_s};
}

tl::expected<void, std::string> Outputs::make_path(const std::string& program) {
    if (recorder_ == nullptr) return {};
    return recorder_->finish(std::filesystem::path(program).stem().string())
        .map([this](path::Program made) { path_ = std::move(made); })
        .map_error(
            [](const std::string& sentence) { return fmt::format("no path is recorded: {}", sentence); });
}

tl::expected<void, std::string> Outputs::write_path() const {
    tl::expected<OutputFile, std::string> file = OutputFile::open(names_.record);
    if (!file) return tl::unexpected(file.error());
    path::write_json(*path_, [&](std::string_view text) { file->write(text); });
    return file->commit();
}

tl::expected<void, std::string> Outputs::commit(const simulation::Report& report) {
    if (trajectory_ != nullptr && trajectory_->cut_short()) {
        return tl::unexpected(fmt::format(
            "{}: the trajectory would have more than {} samples; a longer --step or a lower --max-time makes "
            "it shorter",
            names_.trajectory, simulation::TrajectoryWriter::kMostSamples));
    }
    if (!names_.report.empty()) {
        const auto file = add_file(names_.report);
        if (!file) return tl::unexpected(file.error());
        const std::string json = simulation::to_json(report);
        (*file)->text.buffer().append(json);
        (*file)->text.end_line();
    }
    for (const std::unique_ptr<TextFile>& file : files_) {
        if (auto flushed = file->text.flush(); !flushed) return file->file.cannot_write(flushed.error());
        if (auto settled = file->file.settle(); !settled) return settled;
    }
    for (const std::unique_ptr<TextFile>& file : files_) {
        if (auto committed = file->file.commit(); !committed) return committed;
    }
    if (auto drawn = draw(report); !drawn) return drawn;
    if (path_) return write_path();
    return {};
}

}  // namespace gsim::apps
