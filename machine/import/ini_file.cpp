#include "machine/import/ini_file.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/text/letter_case.h"
#include "base/text/read_number.h"

namespace gsim::import {

namespace {

constexpr std::string_view kInclude = "#INCLUDE";
constexpr int kMaxIncludes = 16;         // within each other
constexpr std::size_t kMaxFiles = 1000;  // in all: a few files that include each other often are many

bool is_same_name(std::string_view a, std::string_view b) {
    return text::upper(a) == text::upper(b);
}

// Returns the value without a trailing remark, which many write.
std::string_view strip_comment(std::string_view value) {
    for (std::size_t at = 1; at < value.size(); ++at) {
        const bool blank_before = value[at - 1] == ' ' || value[at - 1] == '\t';
        if (blank_before && (value[at] == '#' || value[at] == ';')) return trimmed_text(value.substr(0, at));
    }
    return value;
}

// The lines as they count: a line that ends in a backslash continues in the next one.
class LineReader {
  public:
    explicit LineReader(std::string_view text) : text_(text) {}

    bool next() {
        if (at_ >= text_.size()) return false;
        line_.clear();
        first_ = number_ + 1;
        while (at_ < text_.size()) {
            const std::size_t end = std::min(text_.find('\n', at_), text_.size());
            std::string_view fragment = trimmed_text(text_.substr(at_, end - at_));
            at_ = end + 1;
            ++number_;
            const bool continues = fragment.ends_with('\\');
            if (continues) fragment.remove_suffix(1);
            line_ += fragment;
            if (!continues) break;
        }
        return true;
    }
    const std::string& line() const { return line_; }
    std::size_t number() const { return first_; }

  private:
    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t number_ = 0;
    std::size_t first_ = 1;
    std::string line_;
};

}  // namespace

std::string_view trimmed_text(std::string_view text) {
    constexpr std::string_view kWhitespace = " \t\r\n";
    const std::size_t begin = text.find_first_not_of(kWhitespace);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(kWhitespace) - begin + 1);
}

std::optional<double> parse_number_text(std::string_view text) {
    return text::parse_number(trimmed_text(text));
}

double remove_rounding_noise(double value) {
    constexpr double kStepsPerUnit = 1e9;
    return std::round(value * kStepsPerUnit) / kStepsPerUnit;
}

Result<IniFile> IniFile::read(std::string_view text, const std::filesystem::path& path,
                              const os::Files& files) {
    IniFile file;
    file.file_name_ = path.string();
    std::string section;
    return file.add(text, path, {files, section, 0}).map([&] { return std::move(file); });
}

Result<void> IniFile::add(std::string_view text, const std::filesystem::path& path,
                          const IncludeContext& in) {
    LineReader lines(text);
    while (lines.next()) {
        const std::string_view line = lines.line();
        if (line.empty() || line.front() == ';') continue;
        const auto make_error = [&](std::string_view message) {
            return Unexpected(fmt::format("{}:{}: {}", path.string(), lines.number(), message));
        };
        if (line.starts_with(kInclude)) {
            const std::string_view name = trimmed_text(line.substr(kInclude.size()));
            if (Result<void> done =
                    add_included(name, path.parent_path(), {in.files, in.section, in.depth + 1});
                !done)
                return make_error(done.error().message);
            continue;
        }
        if (line.front() == '#') continue;
        if (line.front() == '[') {
            const std::size_t end = line.find(']');
            if (end == std::string_view::npos) return make_error("the section name has no ']'");
            in.section = trimmed_text(line.substr(1, end - 1));
            continue;
        }
        const std::size_t equals = line.find('=');
        if (equals == std::string_view::npos)
            return make_error("a line must be [SECTION], KEY = VALUE or a comment");
        entries_.push_back({.file = path.string(),
                            .section = in.section,
                            .key = std::string(trimmed_text(line.substr(0, equals))),
                            .value = std::string(strip_comment(trimmed_text(line.substr(equals + 1)))),
                            .line = lines.number()});
    }
    return {};
}

Result<void> IniFile::add_included(std::string_view name, const std::filesystem::path& folder,
                                   const IncludeContext& in) {
    if (in.depth > kMaxIncludes)
        return Unexpected(fmt::format("files are included more than {} deep", kMaxIncludes));
    if (++include_count_ > kMaxFiles)
        return Unexpected(fmt::format("more than {} files are included", kMaxFiles));
    const std::filesystem::path path = folder / name;
    return in.files.read_text(path).and_then([&](const std::string& text) { return add(text, path, in); });
}

bool IniFile::has_section(std::string_view section) const {
    return std::any_of(entries_.begin(), entries_.end(),
                       [&](const IniEntry& entry) { return is_same_name(entry.section, section); });
}

const IniEntry* IniFile::find(std::string_view section, std::string_view key) {
    const auto entry = std::find_if(entries_.begin(), entries_.end(), [&](const IniEntry& one) {
        return is_same_name(one.section, section) && is_same_name(one.key, key);
    });
    if (entry == entries_.end()) return nullptr;
    entry->is_used = true;
    return &*entry;
}

std::optional<std::string> IniFile::text(std::string_view section, std::string_view key) {
    const IniEntry* entry = find(section, key);
    if (entry == nullptr) return std::nullopt;
    return entry->value;
}

Result<std::optional<double>> IniFile::number(std::string_view section, std::string_view key) {
    const IniEntry* entry = find(section, key);
    if (entry == nullptr) return std::nullopt;
    const std::optional<double> value = parse_number_text(entry->value);
    if (value) return value;
    return tl::unexpected(
        at(*entry, fmt::format("{} is '{}', which is not a number", entry->key, entry->value)));
}

std::string IniFile::at(const IniEntry& entry, std::string_view message) const {
    return fmt::format("{}:{}: {}", entry.file, entry.line, message);
}

}  // namespace gsim::import
