#include "base/toml/toml_layout.h"

#include <map>
#include <utility>

#include "base/toml/toml_bounds.h"
#include "base/toml/toml_scanner.h"

namespace gsim::base {

namespace {

using Kind = TomlStatement::Kind;

/// Reader of the lines of a document.
class LayoutReader {
  public:
    explicit LayoutReader(std::string_view text) : text_(text), scanner_(text) {}

    std::optional<TomlLayout> read() {
        constexpr std::string_view kMark = "\xEF\xBB\xBF";
        if (text_.starts_with(kMark)) layout_.begin = kMark.size();
        scanner_.seek(layout_.begin);
        while (!scanner_.at_end()) {
            const std::size_t line = scanner_.at();
            scanner_.skip_blanks();
            if (scanner_.at_end() || scanner_.at_line_end()) {
                end_comments(line);
                scanner_.skip_line();
            } else if (scanner_.peek() == '#') {
                if (!comments_) comments_ = line;
                scanner_.skip_line();
            } else if (!read_statement(line)) {
                return std::nullopt;
            }
        }
        end_comments(text_.size());
        return std::move(layout_);
    }

  private:
    // Ends a block of comments at a blank line, or at the end: these comments do not belong to the next
    // statement.
    void end_comments(std::size_t at) {
        if (comments_ && adjacent_) layout_.statements.back().below = at;
        comments_.reset();
        adjacent_ = false;
    }

    bool read_statement(std::size_t line) {
        TomlStatement statement;
        statement.begin = line;
        statement.above = comments_.value_or(line);
        if (scanner_.peek() == '[' ? !read_header(statement) : !read_pair(statement)) return false;
        scanner_.skip_blanks();
        if (!scanner_.at_end() && !scanner_.at_line_end() && scanner_.peek() != '#') return false;
        scanner_.skip_line();
        statement.end = statement.below = scanner_.at();
        layout_.statements.push_back(std::move(statement));
        if (!layout_.statements.back().is_pair()) header_ = layout_.statements.size() - 1;
        comments_.reset();
        adjacent_ = true;
        return true;
    }

    bool read_header(TomlStatement& statement) {
        scanner_.skip(1);
        statement.kind = scanner_.consume('[') ? Kind::entry : Kind::table;
        const auto key = scanner_.read_key();
        if (!key || !scanner_.consume(']') || (statement.kind == Kind::entry && !scanner_.consume(']')))
            return false;
        statement.header = layout_.statements.size();
        statement.address = entry_address(*key, statement.kind);
        return true;
    }

    // Names of tables refer to the newest entry of an array of tables.
    TomlPath entry_address(const TomlPath& key, Kind kind) {
        TomlPath address;
        for (std::size_t i = 0; i < key.size(); ++i) {
            address.push_back(key[i]);
            const bool new_entry = kind == Kind::entry && i + 1 == key.size();
            if (new_entry) ++entries_[address];
            if (const auto found = entries_.find(address); found != entries_.end())
                address.emplace_back(found->second - 1);
        }
        return address;
    }

    bool read_pair(TomlStatement& statement) {
        auto item = scanner_.read_pair();
        if (!item) return false;
        statement.header = header_;
        if (header_ != TomlLayout::kNoHeader) statement.address = layout_.statements[header_].address;
        statement.address.insert(statement.address.end(), item->key.begin(), item->key.end());
        statement.item = *std::move(item);
        return true;
    }

    std::string_view text_;
    TomlScanner scanner_;
    TomlLayout layout_;
    std::map<TomlPath, std::size_t> entries_;  ///< Number of entries of each array of tables so far.
    std::size_t header_ = TomlLayout::kNoHeader;
    std::optional<std::size_t>
        comments_;           ///< Start of the comments that reach down to here without a blank line.
    bool adjacent_ = false;  ///< No blank line is between them and the statement above.
};

}  // namespace

std::optional<TomlLayout> parse_layout(std::string_view toml_text) {
    if (find_toml_bounds_error(toml_text)) return std::nullopt;
    return LayoutReader(toml_text).read();
}

bool is_blank(std::string_view text) {
    return text.find_first_not_of(" \t\r\n") == std::string_view::npos;
}

const TomlValueSpan* find_nested_value(const TomlValueSpan& value_span, const TomlPath& steps) {
    if (steps.empty()) return &value_span;
    if (value_span.kind == TomlValueSpan::Kind::array) {
        const auto* index = std::get_if<std::size_t>(&steps.front());
        if (index == nullptr || *index >= value_span.items.size()) return nullptr;
        return find_nested_value(value_span.items[*index].value, TomlPath(steps.begin() + 1, steps.end()));
    }
    for (const TomlItem& item : value_span.items) {
        if (!has_prefix(steps, item.key)) continue;
        const auto on = steps.begin() + static_cast<std::ptrdiff_t>(item.key.size());
        return find_nested_value(item.value, TomlPath(on, steps.end()));
    }
    return nullptr;
}

}  // namespace gsim::base
