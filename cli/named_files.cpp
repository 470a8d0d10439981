#include "cli/named_files.h"

#include <algorithm>
#include <set>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

#include "base/os/file_identity.h"
#include "base/os/output_file.h"

namespace gsim::apps {

namespace {

/// A given file, as an option's value or as standard output.
struct NamedFile {
    const Option* option = nullptr;  ///< None: standard output.
    std::string value;
    std::optional<os::FileIdentity> identity;  ///< None if it may be named twice.

    bool is_written() const { return option == nullptr || option->file != FileKind::input; }
    std::string description() const {
        return option == nullptr ? std::string("standard output")
                                 : fmt::format("{} '{}'", option->long_name(), value);
    }
};

bool is_standard_stream(const std::string& value) {
    return value == os::kStandardStream;
}

std::optional<os::FileIdentity> value_identity(const Option& option, const std::string& value) {
    if (!is_standard_stream(value)) {
        const bool name = option.allows_name && value.find('.') == std::string::npos;
        return name ? std::nullopt : os::file_identity(value);
    }
    return option.file == FileKind::input ? os::open_file_identity(STDIN_FILENO) : std::nullopt;
}

std::vector<std::string> option_values(const Option& option) {
    if (const auto* one = std::get_if<std::string*>(&option.target)) return {**one};
    if (const auto* many = std::get_if<std::vector<std::string>*>(&option.target)) return **many;
    return {};
}

// Returns true for a flag that is set, or a file that is standard output.
bool is_given(const CommandLine& line, std::string_view name) {
    for (const Option& option : line.options()) {
        if (option.long_name() != name) continue;
        const auto* flag = std::get_if<bool*>(&option.target);
        const auto* file = std::get_if<std::string*>(&option.target);
        return (flag != nullptr && **flag) || (file != nullptr && is_standard_stream(**file));
    }
    return false;
}

class NamedFiles {
  public:
    explicit NamedFiles(const CommandLine& line) {
        add(line);
        files_.push_back({nullptr, {}, os::open_file_identity(STDOUT_FILENO)});
    }

    std::optional<Error> find_conflict() const {
        for (auto second = files_.begin(); second != files_.end(); ++second) {
            for (auto first = files_.begin(); first != second; ++first) {
                if (auto message = conflict(*first, *second)) return message;
            }
        }
        return std::nullopt;
    }

  private:
    void add(const CommandLine& line) {
        for (const Option& option : line.options()) add(option);
        for (const CommandLine& command : line.commands()) add(command);
    }

    // Commands may share a value.
    void add(const Option& option) {
        const bool is_file = option.file != FileKind::none && option.file != FileKind::folder;
        if (!is_file || !targets_.insert(option.target).second) return;
        for (const std::string& value : option_values(option)) {
            if (!value.empty()) files_.push_back({&option, value, value_identity(option, value)});
        }
    }

    static std::optional<Error> conflict(const NamedFile& a, const NamedFile& b) {
        if (!a.is_written() && !b.is_written()) return std::nullopt;
        if (a.option != nullptr && b.option != nullptr) {
            const bool allowed = a.option->shares_file_with == b.option->long_name() ||
                                 b.option->shares_file_with == a.option->long_name();
            if (allowed) return std::nullopt;
            if (a.is_written() && b.is_written() && is_standard_stream(a.value) &&
                is_standard_stream(b.value)) {
                return fmt::format("{} - and {} - both use standard output; write one of them to a file",
                                   a.option->long_name(), b.option->long_name());
            }
        }
        if (!a.identity || a.identity != b.identity) return std::nullopt;
        if (a.is_written() && b.is_written()) {
            return fmt::format("{} and {} are the same file; use a separate file for each output",
                               a.description(), b.description());
        }
        const NamedFile& output = a.is_written() ? a : b;
        const NamedFile& input = a.is_written() ? b : a;
        return fmt::format(
            "{} and {} are the same file, which would be read and overwritten; use a separate file for the "
            "output",
            output.description(), input.description());
    }

    std::set<Target> targets_;
    std::vector<NamedFile> files_;
};

}  // namespace

std::optional<Error> find_file_conflict(const CommandLine& line) {
    if (is_given(line, "--json") && is_given(line, "--sarif"))
        return "--json and --sarif - both use standard output; write --sarif to a file";
    return NamedFiles(line).find_conflict();
}

}  // namespace gsim::apps
