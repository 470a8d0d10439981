#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "base/error.h"
#include "codegen/post/gcode_writer.h"
#include "codegen/post/post.h"
#include "engine/path_translation.h"
#include "engine/src/paths/path_frames.h"
#include "machine/model/machine.h"
#include "toolpath/model/source_location.h"
#include "toolpath/rotary/axis_moves.h"

namespace gsim::engine {

struct PathProgramOptions {
    codegen::WriterOptions words;
    path::RotaryOptions rotary;
    double tolerance_mm = 0.01;
    bool separate_files = false;            ///< Each sub-path in a separate file.
    std::optional<Offsets> offsets = {};    ///< Left out: keep for recorded paths, else as_path.
    std::optional<double> retract_mm = {};  ///< Machine coordinate of Z; left out: the end of its range.
    bool continue_on_unknown =
        false;         ///< Elements without words in the post become comments, instead of an error.
    std::string name;  ///< {program} of the post: the main file's name without its extension.
};

/// The translation of a path to G-code for one machine and one controller.
class PathProgram {
  public:
    /// Plans the axes and checks every move, so that writing cannot fail. The arguments must outlive the
    /// program. The error names the source location in the path's file.
    static Result<PathProgram> plan(const path::PathFile& file, const machine::Machine& machine,
                                    const codegen::Post& post, const PathProgramOptions& options);

    /// Returns messages for the user: sub-segments, unwinding, actions and values for which the post has no
    /// words.
    const std::vector<std::string>& notes() const { return notes_; }
    /// Returns the files to write in addition to the main one.
    std::vector<std::string> file_names() const;
    /// Writes all files; `open_sink` returns the target for the text of a file, "" for the main one.
    void write(const std::function<codegen::GcodeWriter::Sink(const std::string& file)>& open_sink) const;

  private:
    class Sink;

    PathProgram(const path::PathFile& file, path::MachineSpace space, const codegen::Post& post,
                const PathProgramOptions& options)
        : file_(&file),
          space_(std::move(space)),
          post_(&post),
          options_(options),
          states_(file.program),
          frames_(file.program) {}

    bool is_inlined() const { return !post_->subprogram; }
    Offsets offsets() const;
    Result<void> check_offsets() const;
    Result<void> check_work_offset(const std::string& name) const;
    Result<void> check_retract() const;
    path::MoveOptions move_options() const;
    double retract_mm() const { return options_.retract_mm.value_or(space_.max_z_mm().value_or(0)); }
    std::optional<double> thread_lead(const path::AxisMove& move) const;
    Result<void> check_moves();
    tl::expected<void, path::TargetError> check_size() const;
    std::vector<codegen::GcodeAxis> written_axes() const;
    codegen::PlaceholderValues make_placeholders(std::size_t order) const;
    std::string program_file_name(std::size_t order) const;
    void write_path(std::size_t order, Sink& sink) const;

    const path::PathFile* file_;
    path::MachineSpace space_;
    const codegen::Post* post_;
    PathProgramOptions options_;
    path::States states_;
    std::vector<path::RotarySchedule> turns_;
    PathFrames frames_;
    std::vector<std::string> notes_;
    bool has_accelerations_ = false;
};

}  // namespace gsim::engine
