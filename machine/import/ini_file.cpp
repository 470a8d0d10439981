#include "machine/import/ini_file.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/text/letter_case.h"
#include "base/text/read_number.h"

namespace gsim::import {

namespace {

constexpr std::string_view kInclude = "#INCLUDE";
constexpr int kMostIncludes = 16;         // within each other
constexpr std::size_t kMostFiles = 1000;  // in all: a few files that include each other often are many

bool same_name(std::string_view a, std::string_view b) {
    return text::upper(a) == text::upper(b);
}

// Returns the value without the remark that many write after it.
std::string_view without_remark(std::string_view value) {
    for (std::size_t at = 1; at < value.size(); ++at) {
        const bool blank_before = value[at - 1] == ' ' || value[at - 1] == '\t';
        if (blank_before && (value[at] == '#' || value[at] == ';')) return trimmed_text(value.substr(0, at));
    }
    return value;
}

// The lines as they count: a line that ends in a backslash continues in the next one.
class Lines {
  public:
    explicit Lines(std::string_view text) : text_(text) {}

    bool next() {
        if (at_ >= text_.size()) return false;
        line_.clear();
        first_ = number_ + 1;
        while (at_ < text_.size()) {
            const std::size_t end = std::min(text_.find('\n', at_), text_.size());
            std::string_view piece = trimmed_text(text_.substr(at_, end - at_));
            at_ = end + 1;
            ++number_;
            const bool goes_on = piece.ends_with('\\');
            if (goes_on) piece.remove_suffix(1);
            line_ += piece;
            if (!goes_on) break;
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
    constexpr std::string_view kBlanks = " \t\r\n";
    const std::size_t begin = text.find_first_not_of(kBlanks);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

std::optional<double> plain_number(std::string_view text) {
    return text::number_of(trimmed_text(text));
}

double without_noise(double value) {
    constexpr double kPerUnit = 1e9;
    return std::round(value * kPerUnit) / kPerUnit;
}

tl::expected<IniFile, std::string> IniFile::read(std::string_view text, const std::filesystem::path& path,
                                                 const os::Files& files) {
    IniFile file;
    file.file_name_ = path.string();
    std::string section;
    return file.add(text, path, {files, section, 0}).map([&] { return std::move(file); });
}

IniFile::Done IniFile::add(std::string_view text, const std::filesystem::path& path, const Inclusion& in) {
    Lines lines(text);
    while (lines.next()) {
        const std::string_view line = lines.line();
        if (line.empty() || line.front() == ';') continue;
        const auto fault = [&](std::string_view sentence) {
            return tl::unexpected(fmt::format("{}:{}: {}", path.string(), lines.number(), sentence));
        };
        if (line.starts_with(kInclude)) {
            const std::string_view name = trimmed_text(line.substr(kInclude.size()));
            if (Done done = add_included(name, path.parent_path(), {in.files, in.section, in.depth + 1});
                !done)
                return fault(done.error());
            continue;
        }
        if (line.front() == '#') continue;
        if (line.front() == '[') {
            const std::size_t end = line.find(']');
            if (end == std::string_view::npos) return fault("the section's name has no ']'");
            in.section = trimmed_text(line.substr(1, end - 1));
            continue;
        }
        const std::size_t equals = line.find('=');
        if (equals == std::string_view::npos) return fault("a line is [SECTION], KEY = VALUE or a remark");
        entries_.push_back({.file = path.string(),
                            .section = in.section,
                            .key = std::string(trimmed_text(line.substr(0, equals))),
                            .value = std::string(without_remark(trimmed_text(line.substr(equals + 1)))),
                            .line = lines.number()});
    }
    return {};
}

IniFile::Done IniFile::add_included(std::string_view name, const std::filesystem::path& folder,
                                    const Inclusion& in) {
    if (in.depth > kMostIncludes)
        return tl::unexpected(fmt::format("files are included more than {} deep", kMostIncludes));
    if (++included_ > kMostFiles)
        return tl::unexpected(fmt::format("more than {} files are included", kMostFiles));
    const std::filesystem::path path = folder / name;
    return in.files.read_text(path).and_then([&](const std::string& text) { return add(text, path, in); });
}

bool IniFile::has_section(std::string_view section) const {
    return std::any_of(entries_.begin(), entries_.end(),
                       [&](const IniEntry& entry) { return same_name(entry.section, section); });
}

const IniEntry* IniFile::find(std::string_view section, std::string_view key) {
    const auto entry = std::find_if(entries_.begin(), entries_.end(), [&](const IniEntry& one) {
        return same_name(one.section, section) && same_name(one.key, key);
    });
    if (entry == entries_.end()) return nullptr;
    entry->taken = true;
    return &*entry;
}

std::optional<std::string> IniFile::text(std::string_view section, std::string_view key) {
    const IniEntry* entry = find(section, key);
    if (entry == nullptr) return std::nullopt;
    return entry->value;
}

tl::expected<std::optional<double>, std::string> IniFile::number(std::string_view section,
                                                                 std::string_view key) {
    const IniEntry* entry = find(section, key);
    if (entry == nullptr) return std::nullopt;
    const std::optional<double> value = plain_number(entry->value);
    if (value) return value;
    return tl::unexpected(
        at(*entry, fmt::format("{} is '{}', which is no number", entry->key, entry->value)));
}

std::string IniFile::at(const IniEntry& entry, std::string_view sentence) const {
    return fmt::format("{}:{}: {}", entry.file, entry.line, sentence);
}

}  // namespace gsim::import
