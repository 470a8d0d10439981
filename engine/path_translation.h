#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "engine/api.h"
#include "engine/diagnostic.h"
#include "engine/machine.h"
#include "engine/request.h"
#include "engine/run.h"

namespace gsim::engine {

/// How a program finds the places of the machine: by its work coordinate systems, whose offsets the numbers
/// are counted from; with all offsets taken back; in machine coordinates; or, of paths that no run has
/// recorded, as the numbers are.
enum class Offsets : std::uint8_t { as_path, keep, none, machine };

/// What of a path is to be otherwise than in its file.
struct PathChanges {
    /// The path goes along with a frame that stood at `from` and is put to `to` (in the work frame), and
    /// within that by `place`: a point p comes to `to` `place` `from`^-1 p.
    FramePose from = {}, to = {}, place = {};
    /// Of the root's targets, which have to be sub-paths, by their places in the file from 0; empty: as it
    /// is.
    std::vector<std::size_t> order = {};
    struct Feed {
        std::string path = {};  ///< A name; empty: of all paths.
        double value = 1;       ///< Above 0: mm/min, or a factor of what the path has.
        bool is_factor = true;
    };
    std::vector<Feed> feeds = {};
};

/// What is written as a part program, and how. Names are those of files, or what Host::find finds.
struct PathRequest {
    /// Fills a buffer and returns how many bytes it wrote, 0 at the end. The error is a sentence.
    using ReadBytes = std::function<tl::expected<std::size_t, std::string>(char* buffer, std::size_t size)>;

    std::string path = {};     ///< A path file, or a script in Lua that builds one (.lua).
    ReadBytes bytes = {};      ///< A path file that is no file's text (a pipe); `path` is for messages then.
    std::string post = {};     ///< A name of post_names(), or a file that ends in .toml.
    std::string machine = {};  ///< Empty: the one built in.
    std::string machine_data = {};  ///< Where fixed points lie; empty: none, or what `machine` has of them.
    std::string program_name = {};  ///< {program} of the post; empty: the path's name.
    PathChanges changes = {};
    std::optional<bool> rotary_as_given = {};  ///< Left out: of recorded paths, else the least turn.
    std::optional<Offsets> offsets = {};       ///< Left out: keep for recorded paths, else as_path.
    /// Of paths that no run has recorded and that name none: the work coordinate system ("G55"), where the
    /// program puts it (X, Y and Z of the machine), and the tool with the length offset of its number.
    std::string work_offset = {};
    std::optional<std::array<double, 3>> set_offset_mm = {};
    std::optional<int> tool = {};
    /// The machine coordinate of Z that the tool goes up to before it or the work offset changes; left out:
    /// the end of the axis.
    std::optional<double> retract_mm = {};
    double tolerance_mm = 0.01;           ///< By which lines in place of an arc may be off it.
    std::optional<int> decimals_mm = {};  ///< Digits of lengths; left out: the post's.
    bool inch = false;
    bool verbose_words = false;   ///< Words are written though they have not changed.
    bool separate_files = false;  ///< Each sub-path in a file of its own.
    bool go_on = false;           ///< What the post has no words for becomes comments, instead of an error.
    double cpu_s = 86'400;        ///< Of the calling thread, for a script, from open() on.
    std::uint64_t memory_bytes = 2048U << 20U;  ///< For a script.
    Host host = {};
    Cancel cancel = {};
};

/// Names that PathRequest::post takes.
GSIM_API std::vector<std::string> post_names();

/// A path on its way to G-code for one machine and one controller: open(), read(), plan(), write(). What is
/// wrong with the path itself is a failure with `in_program`.
class GSIM_API PathTranslation {
  public:
    /// Reads what the request names beside the path: post, machine and machine data.
    static tl::expected<PathTranslation, Failure> open(PathRequest request);
    PathTranslation(PathTranslation&&) noexcept;
    PathTranslation& operator=(PathTranslation&&) noexcept;
    ~PathTranslation();

    /// The file that the path's name means, of all files the only one that is still to be read.
    const std::string& path_file() const;
    /// Reads the path.
    tl::expected<void, Failure> read();
    /// What is left of PathRequest::cpu_s, in s.
    double cpu_left_s() const;
    /// Behind read(): plans the axes and looks at every move, so that writing cannot fail.
    tl::expected<void, Failure> plan();

    /// Behind plan(): what the user should know, in sentences: pieces, unwinding, what the post has no words
    /// for.
    const std::vector<std::string>& notes() const;
    /// The files to write beside the main one.
    std::vector<std::string> file_names() const;
    /// Writes all; `sink_of` gives where the text of a file goes, "" for the main one. After a sink's false
    /// it gets no more.
    tl::expected<void, Failure> write(const std::function<TextSink(const std::string& file)>& sink_of) const;

  private:
    class State;
    explicit PathTranslation(std::unique_ptr<State> state);

    std::unique_ptr<State> state_;
};

}  // namespace gsim::engine
