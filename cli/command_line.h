#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <list>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace gsim::apps {

/// The kind of a file on the command line; shells complete names by it, and no output may be another named
/// file (named_files.h). A changed file is read and written.
enum class FileKind { none, input, output, changed, folder };

/// The target of an option's value. A bool is a flag; a vector accepts any number of values.
using Target = std::variant<bool*, std::string*, double*, std::uint64_t*, std::optional<double>*,
                            std::vector<std::string>*, std::array<double, 3>*>;

/// An option of a program, or an argument (a name without a dash), in the words that --help, the man page and
/// the completions of shells share.
struct Option {
    /// Range of a number, both limits allowed.
    struct Range {
        double min = 0;
        double max = 0;
    };

    std::string names = {};  ///< "-o,--output", or an argument's name: "part.nc".
    Target target = {};
    std::string help = {};                      ///< Without a full stop.
    std::string group = {};                     ///< Its heading in the help.
    std::string value = {};                     ///< Name of a value: FILE, MM, ...
    std::vector<std::string> choices = {};      ///< The values that there are.
    std::vector<std::string> suggestions = {};  ///< Values for shells to offer; there may be others.
    std::vector<std::string> extensions = {};   ///< File extensions: ".nc".
    std::optional<Range> range = {};
    std::string default_text = {};     ///< Empty: not shown.
    std::string former_name = {};      ///< Its name in the last minor release: accepted with a warning.
    std::string excluded_option = {};  ///< An option that does not go with it.
    FileKind file = FileKind::none;
    std::string shares_file_with = {};  ///< The option with which this one may share a file.
    bool allows_name = false;           ///< Without a dot it is a name of something built in.
    bool required = false;
    bool positive = false;  ///< A number must be more than 0.

    bool is_argument() const { return names.front() != '-'; }
    bool is_flag() const { return std::holds_alternative<bool*>(target); }
    /// Returns "--output" of "-o,--output"; an argument's name unchanged.
    std::string_view long_name() const;
    /// Returns "-o", or nothing.
    std::string_view short_name() const;

    Option& with_value_name(std::string value_name);
    Option& within(double min, double max);
    Option& make_positive();
    Option& one_of(std::vector<std::string> words);
    Option& suggest_values(std::vector<std::string> words);
    Option& takes_file(FileKind kind, std::vector<std::string> extensions_allowed = {});
    Option& or_builtin_name();
    Option& may_share_file_with(std::string other);
    Option& describe_default(std::string text);
    /// Shows the target's current value as the default.
    Option& show_default();
    Option& make_required();
    Option& exclude_option(std::string other);
    Option& formerly(std::string old_name);
};

/// A command to type, and its effect.
struct Example {
    std::string command;
    std::string effect;
};

/// The options and commands of a program: the one table for the parser, --help, the man page and the
/// completions.
class CommandLine {
  public:
    CommandLine(std::string program, std::string description)
        : program_(std::move(program)), description_(std::move(description)) {}

    /// Sets the heading of options that are added from here on.
    void begin_group(std::string heading) { group_ = std::move(heading); }
    Option& add(std::string names, Target target, std::string help);
    /// Adds a command within the program; `on_selected` is called if it is given.
    CommandLine& add_command(std::string name, std::string description,
                             std::function<void()> on_selected = {});
    void add_example(std::string command, std::string effect) {
        examples_.push_back({std::move(command), std::move(effect)});
    }
    /// Adds a paragraph that follows the options.
    void add_note(std::string text) { notes_.push_back(std::move(text)); }

    const std::string& program() const { return program_; }
    const std::string& description() const { return description_; }
    const std::deque<Option>& options() const { return options_; }
    const std::list<CommandLine>& commands() const { return commands_; }
    const std::vector<Example>& examples() const { return examples_; }
    const std::vector<std::string>& notes() const { return notes_; }
    const std::function<void()>& on_selected() const { return on_selected_; }
    /// Returns the headings of options, in the order in which they were begun.
    std::vector<std::string> groups() const;
    /// Returns "gsim-run [options] part.nc", without the preceding commands.
    std::string usage() const;

  private:
    std::string program_;
    std::string description_;
    std::string group_ = "Options";
    std::deque<Option> options_;       // keeps addresses, so that add() can return references
    std::list<CommandLine> commands_;  // of a type that is not complete here
    std::vector<Example> examples_;
    std::vector<std::string> notes_;
    std::function<void()> on_selected_;
};

/// Returns "FILE", "NUMBER", "ab9|rs274ngc": the text that follows an option in its help; empty for a flag.
std::string value_name(const Option& option);

/// Returns the values that shells offer for an option: its choices, or its suggestions.
const std::vector<std::string>& completion_values(const Option& option);

/// Returns the help of an option with its choices, range and default.
std::string full_help(const Option& option);

}  // namespace gsim::apps
