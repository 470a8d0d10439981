#include "engine/src/paths/path_program.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include <fmt/format.h>

#include "base/text/letter_case.h"
#include "base/units.h"
#include "engine/src/paths/path_check.h"
#include "toolpath/json/touches.h"
#include "toolpath/rotary/merged_lines.h"

namespace gsim::engine {

using codegen::GcodeWriter;
using codegen::PlaceholderValues;

namespace {

constexpr double kMaxTargets = 1e8;  // of a program with its sub-paths written inline
constexpr int kFirstLabel = 5001;    // of O-words that repeat a call

std::string sanitized_name(const std::string& name) {
    std::string plain;
    for (const char c : name) {
        plain += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    }
    return plain.empty() ? "path" : plain;
}

}  // namespace

// Writer of moves as blocks.
class PathProgram::Sink : public path::MoveSink {
  public:
    Sink(const PathProgram& program, const path::AxisMoves& moves, GcodeWriter::Sink text)
        : program_(program),
          moves_(moves),
          axes_(program.written_axes()),
          writer_(*program.post_, axes_, program.options_.words, std::move(text)) {
        values_.resize(axes_.size());
        origin_.resize(axes_.size());
        for (const codegen::GcodeAxis& axis : axes_) {
            indices_.push_back(static_cast<Eigen::Index>(*program.space_.machine().find(axis.letter)));
        }
    }

    GcodeWriter& writer() { return writer_; }
    void run(std::size_t path) {
        // PathCheck has checked everything before.
        path::MergedLines merged(*this, program_.space_, program_.move_options());
        static_cast<void>(
            moves_.run(path, program_.space_.is_coupled() ? merged : static_cast<MoveSink&>(*this)));
        merged.finish();
    }
    /// Writes the lines of the program's beginning, then those of the root.
    void begin() {
        const codegen::Post& post = *program_.post_;
        const Offsets offsets = program_.offsets();
        const bool has_frames = program_.frames_.any();
        if (offsets != Offsets::as_path || has_frames) writer_.text().lines(post.offsets.begin);
        // With frames, the controller's frame data count, regardless of the coordinates set for the tool's
        // position.
        const std::string& preset = has_frames                    ? std::string()
                                    : offsets == Offsets::as_path ? post.blocks.start_position
                                                                  : post.offsets.preset;
        if (!preset.empty() && (offsets == Offsets::as_path || offsets == Offsets::none))
            writer_.offsets().preset(preset, written_values(program_.space_.home()));
        for (const auto& [name, position_mm] : program_.frames_.positions_mm()) {
            if (position_mm) writer_.offsets().set_origin(name, *position_mm);
        }
        if (!post.offsets.systems.empty()) writer_.offsets().set_active(post.offsets.systems.front());
        program_.frames_.emit_touches(*this);
    }
    /// Writes the lines before those of the program's end.
    void end() {
        constexpr std::string_view kCancelToolLength = "tool_length_off";
        if (program_.frames_.tools() && program_.post_->actions.contains(kCancelToolLength))
            writer_.action(kCancelToolLength);
        if (program_.frames_.any()) writer_.offsets().select(program_.post_->offsets.systems.front());
        if (program_.offsets() == Offsets::none) writer_.text().lines(program_.post_->offsets.end);
        if (program_.has_accelerations_) writer_.text().lines(program_.post_->acceleration.end);
    }

    void move(const path::AxisMove& move) override {
        const std::span<const double> values = written_values(move.axes);
        if (move.rapid) return writer_.move(values, std::nullopt);
        const codegen::GcodeFeed feed{move.feed_per_min, move.feed_is_rotary, move.duration_s,
                                      move.feed_mm_rev, program_.thread_lead(move)};
        if (!move.arc) return writer_.move(values, feed);
        if (move.arc->via_mm)
            return writer_.arc_through(values, position_vector(*move.arc->via_mm), feed, move.arc->turn_rad);
        constexpr std::array kPlanes = {Plane::yz, Plane::zx, Plane::xy};
        writer_.arc(values,
                    {kPlanes[static_cast<std::size_t>(move.arc->about)], !move.arc->counterclockwise,
                     move.arc->center_offset_mm, move.arc->turn_rad, move.arc->turns},
                    feed);
    }
    void set_position(const path::AxisValues& axes) override {
        writer_.axes().set_position(written_values(axes));
    }
    void retract() override { writer_.machine().retract(program_.retract_mm()); }
    void touch(const std::string& frame, const path::Touch& touch) override {
        writer_.offsets().touch(
            frame, {touch.axis, touch.from_mm, touch.to_mm, path::contact_mm(touch), touch.feed_mm_min});
    }
    void go_to(const path::MachineApproach& machine_path) override {
        if (machine_path.reference > 0)
            return writer_.machine().move_to_reference(machine_path.reference, machine_path.steps);
        writer_.machine().move(machine_path.steps);
    }
    // The numbers of a recorded path are relative to the system's origin in the machine data.
    void work_offset(const std::string& name) override {
        if (program_.offsets() == Offsets::as_path) return writer_.offsets().select(name);
        if (program_.offsets() != Offsets::keep) return;
        const auto& origin = program_.file_->program.work_offsets.find(name)->second.origin;
        for (std::size_t i = 0; i < axes_.size(); ++i) {
            const auto value = origin.find(axes_[i].letter);
            origin_[i] = value == origin.end() ? 0 : value->second;
        }
        writer_.offsets().select(name);
    }
    void dwell(double seconds) override { writer_.dwell(seconds); }
    void acceleration(double mm_s2) override { writer_.acceleration(mm_s2); }
    void action(const std::string& name) override { writer_.action(name); }
    void note(const path::TargetId&, std::string_view message) override { writer_.text().comment(message); }

    void call(const path::SubPath& sub_path) override {
        if (program_.is_inlined()) {
            for (int i = 0; i < sub_path.repeats; ++i) run(sub_path.path);
            return;
        }
        const std::vector<std::size_t>& order = program_.states_.topological_order();
        const auto at = std::find(order.begin(), order.end(), sub_path.path) - order.begin();
        const PlaceholderValues saved_state = writer_.text().placeholders();
        writer_.text().placeholders() = program_.make_placeholders(static_cast<std::size_t>(at));
        writer_.text().placeholders()["repeats"] = fmt::format("{}", sub_path.repeats);
        writer_.text().placeholders()["label"] = fmt::format("{}", next_label_);
        const codegen::SubprogramLines& lines = *program_.post_->subprogram;
        if (sub_path.repeats > 1) ++next_label_;
        writer_.text().lines(sub_path.repeats > 1 ? lines.call_repeated : lines.call);
        writer_.text().placeholders() = saved_state;
        writer_.forget();
    }

  private:
    // Uses X, Y and Z, which are the first axes.
    path::Vector position_vector(const path::Vector& xyz) const {
        return {xyz[0] - origin_[0], xyz[1] - origin_[1], xyz[2] - origin_[2]};
    }
    std::span<const double> written_values(const path::AxisValues& axes) {
        for (std::size_t i = 0; i < values_.size(); ++i) values_[i] = axes[indices_[i]] - origin_[i];
        return values_;
    }

    const PathProgram& program_;
    const path::AxisMoves& moves_;
    std::vector<codegen::GcodeAxis> axes_;
    GcodeWriter writer_;
    std::vector<double> values_;
    std::vector<double> origin_;  // of the numbers: machine coordinates of 0
    std::vector<Eigen::Index> indices_;
    int next_label_ = kFirstLabel;
};

Result<PathProgram> PathProgram::plan(const path::PathFile& file, const machine::Machine& machine,
                                      const codegen::Post& post, const PathProgramOptions& options) {
    auto space = path::MachineSpace::make(machine);
    if (!space) return tl::unexpected(space.error());
    PathProgram program(file, std::move(*space), post, options);
    for (const codegen::GcodeAxis& axis : program.written_axes()) {
        if (post.blocks.axes.empty() || post.blocks.axes.find(axis.letter) != std::string::npos) continue;
        return Unexpected(
            fmt::format("the post '{}' is for the axes {}, but the machine '{}' has {}; give another machine "
                        "with --machine",
                        post.name, post.blocks.axes, machine.name, axis.letter));
    }
    if (!program.options_.words.decimals_mm && file.program.is_recorded())
        program.options_.words.decimals_mm = post.numbers.decimals_recorded_mm;
    program.options_.words.machine_coordinates = program.offsets() == Offsets::machine;
    if (auto checked = program.check_offsets(); !checked) return tl::unexpected(checked.error());
    auto turns = path::plan_rotary(file.program, program.space_, program.states_, options.rotary);
    if (!turns) return tl::unexpected(file.with_location(turns.error().where, turns.error().message));
    program.turns_ = std::move(*turns);
    if (auto checked_moves = program.check_moves(); !checked_moves)
        return tl::unexpected(checked_moves.error());
    return program;
}

Offsets PathProgram::offsets() const {
    return options_.offsets.value_or(file_->program.is_recorded() ? Offsets::keep : Offsets::as_path);
}

Result<void> PathProgram::check_offsets() const {
    const codegen::OffsetWords& words = post_->offsets;
    if (frames_.any() && offsets() != Offsets::as_path)
        return Unexpected("--offsets applies to recorded paths; this path names its work offsets");
    if (frames_.tools() && offsets() == Offsets::machine)
        return Unexpected(
            "--offsets G53 applies to paths that name no tools: length offsets have no effect in machine "
            "coordinates");
    const auto missing_word_error = [this](std::string_view what) {
        return Unexpected(fmt::format("the post '{}' has no word for {}", post_->name, what));
    };
    switch (offsets()) {
        case Offsets::as_path: return {};
        case Offsets::none:
            if (words.preset.empty()) return missing_word_error("the current position ([offsets] here)");
            return {};
        case Offsets::machine:
            if (words.machine.empty()) return missing_word_error("machine coordinates ([offsets] machine)");
            return {};
        case Offsets::keep: break;
    }
    if (!file_->program.is_recorded()) {
        return Unexpected(
            "--offsets keep applies to recorded paths (gsim-run --record), which contain the active offsets");
    }
    for (const auto& [name, offset] : file_->program.work_offsets) {
        if (auto known = check_work_offset(name); !known) return known;
    }
    return {};
}

Result<void> PathProgram::check_work_offset(const std::string& name) const {
    const std::vector<std::string>& systems = post_->offsets.systems;
    const double rotation_deg = file_->program.work_offsets.find(name)->second.rotation_deg;
    if (std::find(systems.begin(), systems.end(), name) == systems.end()) {
        return Unexpected(
            fmt::format("the post '{}' has no word for the work offset G{}; --offsets none or G53 writes the "
                        "program without it",
                        post_->name, name));
    }
    if (rotation_deg == 0) return {};
    return Unexpected(
        fmt::format("the work offset G{} is rotated by {:.10g} degrees, which cannot be written; --offsets "
                    "none or G53 writes the program without it",
                    name, rotation_deg));
}

Result<void> PathProgram::check_retract() const {
    if (post_->offsets.machine.empty()) return {};
    if (!options_.retract_mm && !space_.max_z_mm()) {
        return Unexpected(
            fmt::format("Z of the machine '{}' has no end to which the tool could retract for changes; give "
                        "a height with --retract",
                        space_.machine().name));
    }
    path::AxisValues up = space_.home();
    up[static_cast<Eigen::Index>(*space_.machine().find('Z'))] = retract_mm();
    const auto error = space_.find_axis_range_error(up);
    if (!error) return {};
    return Unexpected(fmt::format("--retract: {}", error->message));
}

// A thread is a line at its feed if the controller has no threads, but the user wants the program anyway.
std::optional<double> PathProgram::thread_lead(const path::AxisMove& move) const {
    const bool has_word = !post_->thread.code.empty() && offsets() != Offsets::machine;
    return has_word ? move.lead_mm : std::nullopt;
}

path::MoveOptions PathProgram::move_options() const {
    const double resolution_mm =
        options_.words.inch
            ? kMmPerInch * std::pow(10.0, -post_->numbers.decimals_inch)
            : std::pow(10.0, -options_.words.decimals_mm.value_or(post_->numbers.decimals_mm));
    const auto oblique = post_->arcs.through_point     ? path::ObliqueArcs::through_points
                         : post_->arcs.rejects_oblique ? path::ObliqueArcs::rejected
                                                       : path::ObliqueArcs::lines;
    return {options_.tolerance_mm,
            resolution_mm,
            oblique,
            offsets() != Offsets::machine,
            !post_->arcs.turns_letter.empty(),
            {post_->tool_change.stops_spindle, post_->tool_change.stops_coolant},
            frames_.positions_mm(),
            options_.retract_mm ? options_.retract_mm : space_.max_z_mm()};
}

Result<void> PathProgram::check_moves() {
    const auto with_location = [this](const path::TargetError& error) {
        return tl::unexpected(file_->with_location(error.where, error.message));
    };
    if (is_inlined()) {
        if (auto size = check_size(); !size) return with_location(size.error());
    }
    const path::AxisMoves moves(file_->program, space_, states_, turns_, move_options());
    PathCheck check(*file_, *post_, offsets() == Offsets::machine, options_.continue_on_unknown);
    if (const auto touch_error = frames_.check_touches(space_)) return with_location(*touch_error);
    frames_.emit_touches(check);
    for (const std::size_t path : states_.topological_order()) {
        if (auto run = moves.run(path, check); !run) return with_location(run.error());
    }
    auto found = check.finish();
    if (!found) return tl::unexpected(found.error());
    notes_ = frames_.notes();
    notes_.insert(notes_.end(), found->notes.begin(), found->notes.end());
    options_.words.feed_modes = found->feed_modes;
    has_accelerations_ = found->accelerations;
    return found->retracts ? check_retract() : Result<void>();
}

tl::expected<void, path::TargetError> PathProgram::check_size() const {
    std::vector<double> sizes(file_->program.paths.size(), 0);
    const std::vector<std::size_t>& order = states_.topological_order();
    for (auto path = order.rbegin(); path != order.rend(); ++path) {
        for (const path::Target& target : file_->program.paths[*path].targets) {
            const auto* sub_path = std::get_if<path::SubPath>(&target);
            sizes[*path] += sub_path == nullptr ? 1 : sub_path->repeats * sizes[sub_path->path];
        }
    }
    const double size = sizes[file_->program.root];
    if (size <= kMaxTargets) return {};
    return tl::unexpected(
        path::TargetError{{file_->program.root, std::nullopt},
                          fmt::format("the post '{}' has no subprograms, and the path with all expanded "
                                      "sub-paths has {:.3g} points; the max is {:.0e}",
                                      post_->name, size, kMaxTargets)});
}

std::vector<codegen::GcodeAxis> PathProgram::written_axes() const {
    std::vector<codegen::GcodeAxis> axes{{'X', false}, {'Y', false}, {'Z', false}};
    for (std::size_t i = 0; i < space_.rotary_count(); ++i)
        axes.push_back({space_.rotary_axis(i).letter, true});
    return axes;
}

PlaceholderValues PathProgram::make_placeholders(std::size_t order) const {
    const std::size_t path = states_.topological_order()[order];
    const std::string name = sanitized_name(options_.name);
    const std::string& title =
        order == 0 && !file_->program.name.empty() ? file_->program.name : file_->program.paths[path].name;
    return {{"number", fmt::format("{:04}", order + 1)},
            {"title", codegen::comment_text(title)},
            {"program", name},
            {"lower", text::lower(name)},
            {"unit", options_.words.inch ? "G20" : "G21"}};
}

std::string PathProgram::program_file_name(std::size_t order) const {
    if (order == 0 || is_inlined() || !options_.separate_files) return {};
    return codegen::fill_template(post_->subprogram->file, make_placeholders(order));
}

std::vector<std::string> PathProgram::file_names() const {
    std::vector<std::string> names;
    if (is_inlined() || !options_.separate_files) return names;
    for (std::size_t order = 1; order < states_.topological_order().size(); ++order)
        names.push_back(program_file_name(order));
    return names;
}

void PathProgram::write_path(std::size_t order, Sink& sink) const {
    GcodeWriter& writer = sink.writer();
    writer.text().placeholders() = make_placeholders(order);
    writer.forget();
    writer.text().lines(order == 0 ? post_->begin : post_->subprogram->begin);
    if (order == 0) sink.begin();
    sink.run(states_.topological_order()[order]);
    if (order == 0) sink.end();
    writer.text().lines(order == 0 ? post_->end : post_->subprogram->end);
}

void PathProgram::write(const std::function<GcodeWriter::Sink(const std::string& file)>& open_sink) const {
    const path::AxisMoves moves(file_->program, space_, states_, turns_, move_options());
    Sink main(*this, moves, open_sink({}));
    const std::size_t paths = is_inlined() ? 1 : states_.topological_order().size();
    std::vector<std::size_t> sequence(paths);
    for (std::size_t i = 0; i < paths; ++i) sequence[i] = i;
    if (!is_inlined() && post_->subprogram->before_program) std::reverse(sequence.begin(), sequence.end());
    for (const std::size_t order : sequence) {
        const std::string file = program_file_name(order);
        if (file.empty()) {
            write_path(order, main);
        } else {
            Sink file_sink(*this, moves, open_sink(file));
            write_path(order, file_sink);
            file_sink.writer().text().flush();
        }
    }
    main.writer().text().flush();
}

}  // namespace gsim::engine
