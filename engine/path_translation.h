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

/// Reference of the positions in a program: its work coordinate systems, with numbers relative to their
/// offsets; no offsets, all cancelled; machine coordinates; or, for paths that no run has recorded, the
/// numbers as they are.
enum class Offsets : std::uint8_t { as_path, keep, none, machine };

/// Changes to a path relative to its file.
struct PathChanges {
    /// Pose change: the path moves with a frame from the pose `from` to the pose `to` (in the work frame),
    /// and within that by `place`: a point p moves to `to` `place` `from`^-1 p.
    FramePose from = {}, to = {}, place = {};
    /// Order of the root's targets, which have to be sub-paths, by their positions in the file from 0; empty:
    /// unchanged.
    std::vector<std::size_t> order = {};
    struct Feed {
        std::string path = {};  ///< A name; empty: of all paths.
        double value = 1;       ///< Above 0: mm/min, or a factor of what the path has.
        bool is_factor = true;
    };
    std::vector<Feed> feeds = {};
};

/// Form of a written program.
struct ProgramFormat {
    double tolerance_mm = 0.01;           ///< Max deviation of lines that replace an arc.
    std::optional<int> decimals_mm = {};  ///< Digits of lengths; left out: the post's.
    bool inch = false;
    bool verbose_words = false;   ///< Words are written though they have not changed.
    bool separate_files = false;  ///< Each sub-path in a separate file.
    /// Elements without words in the post become comments, instead of an error.
    bool continue_on_unknown = false;
};

/// The path to write as a part program, and its options. Names are those of files, or as Host::find finds
/// them.
struct PathRequest {
    /// Fills a buffer and returns the number of bytes written, 0 at the end. The error is a message.
    using ReadBytes = std::function<tl::expected<std::size_t, std::string>(char* buffer, std::size_t size)>;

    std::string path = {};     ///< A path file, or a script in Lua that builds one (.lua).
    ReadBytes bytes = {};      ///< A path file that is no file's text (a pipe); `path` is for messages then.
    std::string post = {};     ///< A name of post_names(), or a file that ends in .toml.
    std::string machine = {};  ///< Empty: the one built in.
    std::string machine_data = {};  ///< Fixed points; empty: none, or those of `machine`.
    std::string program_name = {};  ///< {program} of the post; empty: the path's name.
    PathChanges changes = {};
    std::optional<bool> rotary_as_given = {};  ///< Missing: for recorded paths, else the smallest turn.
    std::optional<Offsets> offsets = {};       ///< Left out: keep for recorded paths, else as_path.
    /// For paths that no run has recorded and that name none: the work coordinate system ("G55"), its
    /// position set by the program (X, Y and Z of the machine), and the tool; its length offset has the same
    /// number.
    std::string work_offset = {};
    std::optional<std::array<double, 3>> set_offset_mm = {};
    std::optional<int> tool = {};
    /// The machine coordinate of Z to which the tool retracts before it or the work offset changes; if
    /// missing: the end of the axis.
    std::optional<double> retract_mm = {};
    ProgramFormat format = {};
    double cpu_s = 86'400;                      ///< For a script, in the calling thread, from open() on.
    std::uint64_t memory_bytes = 2048U << 20U;  ///< For a script.
    Host host = {};
    Cancel cancel = {};
};

/// Returns the names valid for PathRequest::post.
GSIM_API std::vector<std::string> post_names();

/// The translation of a path to G-code for one machine and one controller: open(), read(), plan(), write().
/// An error of the path itself is a failure with `in_program`.
class GSIM_API PathTranslation {
  public:
    /// Reads the files that the request names in addition to the path: post, machine and machine data.
    static tl::expected<PathTranslation, Error> open(PathRequest request);
    PathTranslation(PathTranslation&&) noexcept;
    PathTranslation& operator=(PathTranslation&&) noexcept;
    ~PathTranslation();

    /// Returns the file of the path's name, the only one that is not yet read.
    const std::string& path_file() const;
    /// Reads the path.
    tl::expected<void, Error> read();
    /// Returns the remainder of PathRequest::cpu_s, in s.
    double cpu_left_s() const;
    /// Plans the axes once read() has succeeded, and checks every move, so that writing cannot fail.
    tl::expected<void, Error> plan();

    /// Returns messages for the user, after plan(): sub-segments, unwinding, elements for which the post has
    /// no words.
    const std::vector<std::string>& notes() const;
    /// Returns the files to write in addition to the main one.
    std::vector<std::string> file_names() const;
    /// Writes all files; `open_sink` returns the target for the text of a file, "" for the main one. A file
    /// stops when its sink returns false.
    tl::expected<void, Error> write(const std::function<TextSink(const std::string& file)>& open_sink) const;

  private:
    class State;
    explicit PathTranslation(std::unique_ptr<State> state);

    std::unique_ptr<State> state_;
};

}  // namespace gsim::engine
