// path2gcode: writes a path as a part program for a machine and its controller.

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/ranges.h>

#include "apps/exit_status.h"
#include "apps/path_input.h"
#include "apps/path_program.h"
#include "apps/run_main.h"
#include "codegen/post_file.h"
#include "runtime/machine/machine_file.h"
#include "runtime/simulation/output_file.h"

namespace {

using namespace gsim;
namespace fs = std::filesystem;

struct Arguments {
    std::string input = "-";
    std::string output;
    std::string post = "ab9";
    std::string machine;
    std::string rotary = "least-turn";
    double tolerance_mm = 0.01;
    bool inch = false;
    bool verbose_words = false;
    bool separate_files = false;
    bool quiet = false;
};

constexpr const char* kProgram = "path2gcode";
constexpr const char* kAsGiven = "as-given";

int usage_error(const std::string& message) {
    return apps::usage_error(kProgram, message);
}

void add_options(CLI::App& app, Arguments& a) {
    app.add_option("part.path.json|part.lua", a.input, "path, or - for a path file on standard input")
        ->capture_default_str();
    app.add_option("-o,--output", a.output,
                   "write the program to this file; it appears only if all went well");
    app.add_option("--dialect", a.post,
                   fmt::format("how the controller wants programs: {}, or a file that ends in .toml",
                               fmt::join(codegen::built_in_posts(), ", ")))
        ->capture_default_str();
    app.add_option("--machine", a.machine,
                   "machine file (TOML); without it the 5-axis waterjet gantry that is built in");
    app.add_option(
           "--rotary", a.rotary,
           "least-turn: rotary axes go the way that turns least; as-given: rotary_deg is taken as it is")
        ->check(CLI::IsMember({"least-turn", kAsGiven}))
        ->capture_default_str();
    app.add_option("--tolerance", a.tolerance_mm, "mm by which lines in place of an arc may be off it")
        ->check(CLI::Range(1e-4, 10.0))
        ->capture_default_str();
    app.add_flag("--inch", a.inch, "the program is in inches");
    app.add_flag("--verbose-words", a.verbose_words, "write words though they have not changed");
    app.add_flag("--separate-files", a.separate_files,
                 "each sub-path in a file of its own beside the output");
    app.add_flag("--quiet", a.quiet, "no notes on standard error");
    app.set_version_flag("--version", "path2gcode " GSIM_VERSION);
}

// Files that get their names together, once all are written.
class Files {
  public:
    tl::expected<void, std::string> open(const fs::path& main, const std::vector<std::string>& beside) {
        if (auto opened = add("", main); !opened) return opened;
        for (const std::string& name : beside) {
            if (auto opened = add(name, main.parent_path() / name); !opened) return opened;
        }
        return {};
    }
    std::FILE* stream(const std::string& name) const { return files_.at(name)->stream(); }
    tl::expected<void, std::string> commit() {
        for (auto& [name, file] : files_) {
            if (auto committed = file->commit(); !committed) return committed;
        }
        return {};
    }

  private:
    tl::expected<void, std::string> add(const std::string& name, const fs::path& path) {
        auto file = simulation::OutputFile::open(path);
        if (!file) return tl::unexpected(file.error());
        files_.emplace(name, std::make_unique<simulation::OutputFile>(std::move(*file)));
        return {};
    }

    std::map<std::string, std::unique_ptr<simulation::OutputFile>> files_;
};

codegen::GcodeWriter::Sink into(std::FILE* stream) {
    return [stream](std::string_view text) { std::fwrite(text.data(), 1, text.size(), stream); };
}

int write(const apps::PathProgram& program, const std::string& output) {
    if (output.empty()) {
        program.write([](const std::string&) { return into(stdout); });
        const bool written = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
        return written ? apps::kDone : usage_error("standard output cannot be written");
    }
    Files files;
    if (auto opened = files.open(output, program.file_names()); !opened) return usage_error(opened.error());
    program.write([&files](const std::string& name) { return into(files.stream(name)); });
    const auto committed = files.commit();
    return committed ? apps::kDone : usage_error(committed.error());
}

int path_fault(const std::string& message) {
    std::fprintf(stderr, "%s\n", message.c_str());
    return apps::kProgramFault;
}

int run(const Arguments& a) {
    if (a.separate_files && a.output.empty()) return usage_error("--separate-files needs --output");
    const auto post = codegen::find_post(a.post);
    if (!post) return usage_error(post.error());
    const auto machine = a.machine.empty()
                             ? machine::read_machine(machine::built_in_machine_toml(), "af5.toml")
                             : machine::load_machine(a.machine);
    if (!machine) return usage_error(machine.error());
    const auto file = apps::read_path(a.input);
    if (!file) return path_fault(file.error());

    apps::PathProgramOptions options;
    options.words = {a.inch, a.verbose_words};
    options.rotary.as_given = a.rotary == kAsGiven;
    options.tolerance_mm = a.tolerance_mm;
    options.separate_files = a.separate_files;
    options.name = a.output.empty() ? file->program.name : fs::path(a.output).stem().string();
    const auto program = apps::PathProgram::plan(*file, *machine, *post, options);
    if (!program) return path_fault(program.error());
    if (!a.quiet) {
        for (const std::string& note : program->notes()) std::fprintf(stderr, "note: %s\n", note.c_str());
    }
    return write(*program, a.output);
}

}  // namespace

int main(int argc, char** argv) {
    return apps::run_main<Arguments>(argc, argv, kProgram,
                                     "Writes a path of points as a part program (G-code).", add_options, run);
}
