#include "apps/path_program.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/format.h>

#include "runtime/path/merged_lines.h"
#include "text/letter_case.h"

namespace gsim::apps {

using codegen::GcodeWriter;
using codegen::Places;
using path::Fault;

namespace {

constexpr double kMostTargets = 1e8;  // of a program whose sub-paths are written where they are used
constexpr std::size_t kMostNotes = 20;
constexpr int kFirstLabel = 5001;  // of O-words that repeat a call

std::string plain_name(const std::string& name) {
    std::string plain;
    for (const char c : name) {
        plain += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    }
    return plain.empty() ? "path" : plain;
}

}  // namespace

// Looks at the moves, so that what is wrong is known before anything is written, and gathers what to tell.
class PathProgram::Check : public path::MoveSink {
  public:
    explicit Check(PathProgram& program) : program_(program) {}

    void move(const path::AxisMove&) override {}
    void dwell(double) override {}
    void acceleration(double) override { ++program_.accelerations_; }
    void action(const std::string& name) override {
        if (program_.post_->actions.find(name) == program_.post_->actions.end()) ++without_word_[name];
    }
    void call(const path::SubPath&) override {}
    void note(const path::TargetId& where, std::string_view sentence) override {
        if (++count_ <= kMostNotes) {
            program_.notes_.push_back(program_.file_->located(where, std::string(sentence)));
        }
    }

    void finish() {
        if (count_ > kMostNotes) {
            program_.notes_.push_back(fmt::format("{} more notes of this kind", count_ - kMostNotes));
        }
        if (program_.accelerations_ > 0 && program_.post_->acceleration.empty()) {
            program_.notes_.push_back(fmt::format(
                "'acceleration_mm_s2' of {} points is not written: the post '{}' has no words for it",
                program_.accelerations_, program_.post_->name));
        }
        for (const auto& [name, count] : without_word_) {
            program_.notes_.push_back(
                fmt::format("action '{}' is a comment, {} times: the post '{}' has no block for it", name,
                            count, program_.post_->name));
        }
    }

  private:
    PathProgram& program_;
    std::size_t count_ = 0;
    std::map<std::string, int> without_word_;
};

// Moves as blocks.
class PathProgram::Sink : public path::MoveSink {
  public:
    Sink(const PathProgram& program, const path::AxisMoves& moves, GcodeWriter::Sink text)
        : program_(program),
          moves_(moves),
          axes_(program.written_axes()),
          writer_(*program.post_, axes_, program.options_.words, std::move(text)) {
        values_.resize(axes_.size());
        for (const codegen::WrittenAxis& axis : axes_) {
            indices_.push_back(static_cast<Eigen::Index>(*program.space_.machine().find(axis.letter)));
        }
    }

    GcodeWriter& writer() { return writer_; }
    void run(std::size_t path) {
        // Everything was looked at in Check.
        path::MergedLines merged(*this, program_.space_, program_.move_options());
        static_cast<void>(
            moves_.run(path, program_.space_.coupled() ? merged : static_cast<MoveSink&>(*this)));
        merged.finish();
    }
    void start_position() { writer_.start_position(values_of(program_.space_.home())); }

    void move(const path::AxisMove& move) override {
        const std::span<const double> values = values_of(move.axes);
        if (move.rapid) return writer_.move(values, std::nullopt);
        const codegen::WrittenFeed feed{move.feed_per_min, move.feed_is_rotary};
        if (!move.arc) return writer_.move(values, feed);
        constexpr std::array kPlanes = {codegen::ArcPlane::about_x, codegen::ArcPlane::about_y,
                                        codegen::ArcPlane::about_z};
        writer_.arc(values,
                    {kPlanes[static_cast<std::size_t>(move.arc->about)], !move.arc->counterclockwise,
                     move.arc->center_offset_mm},
                    feed);
    }
    void dwell(double seconds) override { writer_.dwell(seconds); }
    void acceleration(double mm_s2) override { writer_.acceleration(mm_s2); }
    void action(const std::string& name) override { writer_.action(name); }
    void note(const path::TargetId&, std::string_view sentence) override { writer_.comment(sentence); }

    void call(const path::SubPath& sub_path) override {
        if (program_.inlined()) {
            for (int i = 0; i < sub_path.repeats; ++i) run(sub_path.path);
            return;
        }
        const std::vector<std::size_t>& order = program_.states_.users_first();
        const auto at = std::find(order.begin(), order.end(), sub_path.path) - order.begin();
        const Places saved = writer_.places();
        writer_.places() = program_.places_of(static_cast<std::size_t>(at));
        writer_.places()["repeats"] = fmt::format("{}", sub_path.repeats);
        writer_.places()["label"] = fmt::format("{}", next_label_);
        const codegen::SubprogramLines& lines = *program_.post_->subprogram;
        if (sub_path.repeats > 1) ++next_label_;
        writer_.lines(sub_path.repeats > 1 ? lines.call_repeated : lines.call);
        writer_.places() = saved;
        writer_.forget();
    }

  private:
    std::span<const double> values_of(const path::AxisValues& axes) {
        for (std::size_t i = 0; i < values_.size(); ++i) values_[i] = axes[indices_[i]];
        return values_;
    }

    const PathProgram& program_;
    const path::AxisMoves& moves_;
    std::vector<codegen::WrittenAxis> axes_;
    GcodeWriter writer_;
    std::vector<double> values_;
    std::vector<Eigen::Index> indices_;
    int next_label_ = kFirstLabel;
};

tl::expected<PathProgram, std::string> PathProgram::plan(const path::PathFile& file,
                                                         const machine::Machine& machine,
                                                         const codegen::Post& post,
                                                         const PathProgramOptions& options) {
    auto space = path::MachineSpace::make(machine);
    if (!space) return tl::unexpected(space.error());
    PathProgram program(file, std::move(*space), post, options);
    for (const codegen::WrittenAxis& axis : program.written_axes()) {
        if (post.axes.empty() || post.axes.find(axis.letter) != std::string::npos) continue;
        return tl::unexpected(
            fmt::format("the post '{}' is for the axes {}, and the machine '{}' has {}; name another machine "
                        "by --machine",
                        post.name, post.axes, machine.name, axis.letter));
    }
    auto turns = path::plan_rotary(file.program, program.space_, program.states_, options.rotary);
    if (!turns) return tl::unexpected(file.located(turns.error().where, turns.error().sentence));
    program.turns_ = std::move(*turns);
    if (auto looked = program.look_at_moves(); !looked) {
        return tl::unexpected(file.located(looked.error().where, looked.error().sentence));
    }
    return program;
}

path::MoveOptions PathProgram::move_options() const {
    const double digit_mm = options_.words.inch ? 25.4 * std::pow(10.0, -post_->decimals_inch)
                                                : std::pow(10.0, -post_->decimals_mm);
    return {options_.tolerance_mm, digit_mm};
}

tl::expected<void, Fault> PathProgram::look_at_moves() {
    if (inlined()) {
        if (auto size = check_size(); !size) return size;
    }
    const path::AxisMoves moves(file_->program, space_, states_, turns_, move_options());
    Check check(*this);
    for (const std::size_t path : states_.users_first()) {
        if (auto run = moves.run(path, check); !run) return run;
    }
    check.finish();
    return {};
}

tl::expected<void, Fault> PathProgram::check_size() const {
    std::vector<double> sizes(file_->program.paths.size(), 0);
    const std::vector<std::size_t>& order = states_.users_first();
    for (auto path = order.rbegin(); path != order.rend(); ++path) {
        for (const path::Target& target : file_->program.paths[*path].targets) {
            const auto* sub_path = std::get_if<path::SubPath>(&target);
            sizes[*path] += sub_path == nullptr ? 1 : sub_path->repeats * sizes[sub_path->path];
        }
    }
    const double size = sizes[file_->program.root];
    if (size <= kMostTargets) return {};
    return tl::unexpected(
        Fault{{file_->program.root, std::nullopt},
              fmt::format("the post '{}' has no subprograms, and all sub-paths written where they are used "
                          "come to {:.3g} points; {:.0e} is the most",
                          post_->name, size, kMostTargets)});
}

std::vector<codegen::WrittenAxis> PathProgram::written_axes() const {
    std::vector<codegen::WrittenAxis> axes{{'X', false}, {'Y', false}, {'Z', false}};
    for (std::size_t i = 0; i < space_.rotary_count(); ++i)
        axes.push_back({space_.rotary_axis(i).letter, true});
    return axes;
}

Places PathProgram::places_of(std::size_t order) const {
    const std::size_t path = states_.users_first()[order];
    const std::string name = plain_name(options_.name);
    const std::string& title =
        order == 0 && !file_->program.name.empty() ? file_->program.name : file_->program.paths[path].name;
    return {{"number", fmt::format("{:04}", order + 1)},
            {"title", codegen::comment_text(title)},
            {"program", name},
            {"lower", text::lower(name)},
            {"unit", options_.words.inch ? "G20" : "G21"}};
}

std::string PathProgram::file_of(std::size_t order) const {
    if (order == 0 || inlined() || !options_.separate_files) return {};
    return codegen::filled(post_->subprogram->file, places_of(order));
}

std::vector<std::string> PathProgram::file_names() const {
    std::vector<std::string> names;
    if (inlined() || !options_.separate_files) return names;
    for (std::size_t order = 1; order < states_.users_first().size(); ++order)
        names.push_back(file_of(order));
    return names;
}

void PathProgram::write_path(std::size_t order, Sink& sink) const {
    GcodeWriter& writer = sink.writer();
    writer.places() = places_of(order);
    writer.forget();
    writer.lines(order == 0 ? post_->begin : post_->subprogram->begin);
    if (order == 0) sink.start_position();
    sink.run(states_.users_first()[order]);
    if (order == 0 && accelerations_ > 0) writer.lines(post_->end_acceleration);
    writer.lines(order == 0 ? post_->end : post_->subprogram->end);
}

void PathProgram::write(const std::function<GcodeWriter::Sink(const std::string& file)>& sink_of) const {
    const path::AxisMoves moves(file_->program, space_, states_, turns_, move_options());
    Sink main(*this, moves, sink_of({}));
    const std::size_t paths = inlined() ? 1 : states_.users_first().size();
    std::vector<std::size_t> sequence(paths);
    for (std::size_t i = 0; i < paths; ++i) sequence[i] = i;
    if (!inlined() && post_->subprogram->before_program) std::reverse(sequence.begin(), sequence.end());
    for (const std::size_t order : sequence) {
        const std::string file = file_of(order);
        if (file.empty()) {
            write_path(order, main);
        } else {
            Sink own(*this, moves, sink_of(file));
            write_path(order, own);
            own.writer().flush();
        }
    }
    main.writer().flush();
}

}  // namespace gsim::apps
