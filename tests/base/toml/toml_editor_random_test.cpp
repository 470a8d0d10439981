#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/toml/toml_editor.h"
#include "tests/build_files/build_files.h"

namespace gsim::base {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

std::string read_file_text(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::vector<std::filesystem::path> samples() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(tests::source_path("samples"))) {
        if (entry.path().extension() == ".toml") files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

/// All values of a document but the document.
void collect(const json& value, const TomlPath& path, std::vector<TomlPath>& paths) {
    if (!path.empty()) paths.push_back(path);
    std::size_t index = 0;
    for (const auto& [key, inner] : value.items()) {
        if (!value.is_structured()) return;
        collect(inner, value.is_array() ? below(path, index++) : below(path, key), paths);
    }
}

json::json_pointer pointer(const TomlPath& path) {
    json::json_pointer to;
    for (const TomlStep& step : path) {
        if (const auto* index = std::get_if<std::size_t>(&step)) {
            to /= *index;
        } else {
            to /= std::get<std::string>(step);
        }
    }
    return to;
}

std::vector<std::string> lines(const std::string& text) {
    std::vector<std::string> all;
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        all.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return all;
}

/// Returns the number of lines of `before` that are not in `after`, in any order, without blank ones.
std::size_t lost_lines(const std::string& before, const std::string& after) {
    std::map<std::string, int> counts;
    for (const std::string& line : lines(after)) ++counts[line];
    std::size_t lost = 0;
    for (const std::string& line : lines(before)) {
        if (!line.empty() && --counts[line] < 0) ++lost;
    }
    return lost;
}

/// Returns the number of these with a comment.
std::size_t lost_comments(const std::string& before, const std::string& after) {
    std::string commented;
    for (const std::string& line : lines(before)) {
        if (line.find('#') != std::string::npos) commented += line + '\n';
    }
    return lost_lines(commented, after);
}

/// A value without the tables and lists in it that are empty: whether these are there is up to how they are
/// made.
json without_empty(const json& value) {
    if (!value.is_structured()) return value;
    json kept = value.is_array() ? json::array() : json::object();
    for (const auto& [key, inner] : value.items()) {
        json each = without_empty(inner);
        if (inner.is_structured() && each.empty()) continue;
        if (value.is_array()) {
            kept.push_back(std::move(each));
        } else {
            kept[key] = std::move(each);
        }
    }
    return kept;
}

class RandomEdits {
  public:
    RandomEdits(const std::string& text, unsigned seed) : text_(text), random_(seed) {
        const json document = *toml_json(text, "sample");
        collect(document, {}, paths_);
    }

    void try_one() {
        auto edit = TomlEditor::read(text_, "sample");
        ASSERT_TRUE(edit);
        const json before = edit->value();
        const TomlPath path = any(paths_);
        const json old = before.at(pointer(path));
        switch (random_() % 5) {
            case 0: return set(*edit, path, old);
            case 4: return set_list(*edit, path, old);
            case 1: return remove(*edit, path, old);
            case 2: return add(*edit, path, old);
            default: return move(*edit, path, before);
        }
    }

  private:
    template <typename List>
    const typename List::value_type& any(const List& list) {
        return list[random_() % list.size()];
    }

    json other_value() {
        static const std::vector<json> kValues{
            0.125, -7, true, "text # \"x\" \xC3\xA4", 1e30, json::array({1, 2.5})};
        return any(kValues);
    }

    void set(TomlEditor& edit, const TomlPath& path, const json& old) {
        if (old.is_structured()) return;
        const json value = other_value();
        const auto done = edit.set(path, value);
        ASSERT_TRUE(done) << done.error().message;
        json expected_value = *toml_json(text_, "sample");
        expected_value.at(pointer(path)) = value;
        EXPECT_EQ(edit.value(), expected_value);
        EXPECT_EQ(lines(edit.text()).size(), lines(text_).size());
        EXPECT_LE(lost_lines(text_, edit.text()), 1U) << edit.text();
        ASSERT_TRUE(edit.set(path, old));
        EXPECT_EQ(edit.value(), *toml_json(text_, "sample"));
    }

    // Sets some of its elements, one of them twice, in another order: no comment may follow another value.
    void set_list(TomlEditor& edit, const TomlPath& path, const json& old) {
        if (!old.is_array() || old.empty()) return;
        ordered_json value = ordered_json::array({any(old)});
        for (const json& each : old) {
            if (random_() % 3 == 0) continue;
            value.insert(value.begin() + static_cast<std::ptrdiff_t>(random_() % value.size()), each);
        }
        const auto done = edit.set(path, value);
        ASSERT_TRUE(done) << done.error().message;
        json expected_value = *toml_json(text_, "sample");
        expected_value.at(pointer(path)) = value;
        EXPECT_EQ(edit.value(), expected_value) << edit.text();
        if (!old.front().is_structured()) {
            EXPECT_LE(lost_comments(edit.text(), text_), 1U) << edit.text();
        }
        const auto back = edit.set(path, old);
        ASSERT_TRUE(back) << back.error().message;
        EXPECT_EQ(edit.value(), *toml_json(text_, "sample")) << edit.text();
    }

    void remove(TomlEditor& edit, const TomlPath& path, const json& old) {
        const json before = edit.value();
        const auto done = edit.remove(path);
        ASSERT_TRUE(done) << done.error().message;
        json expected_value = before;
        const json::json_pointer to = pointer(path);
        if (std::holds_alternative<std::size_t>(path.back())) {
            expected_value.at(to.parent_pointer()).erase(std::get<std::size_t>(path.back()));
        } else {
            expected_value.at(to.parent_pointer()).erase(std::get<std::string>(path.back()));
        }
        EXPECT_EQ(without_empty(edit.value()), without_empty(expected_value)) << edit.text();
        EXPECT_EQ(lost_lines(edit.text(), text_) > 1, false) << edit.text();
        if (std::holds_alternative<std::size_t>(path.back())) {
            const TomlPath list(path.begin(), path.end() - 1);
            const auto added = edit.add(list, old);
            ASSERT_TRUE(added) << added.error().message << edit.text();
            const std::size_t last = before.at(to.parent_pointer()).size() - 1;
            const auto moved = edit.move(below(list, last), std::get<std::size_t>(path.back()));
            ASSERT_TRUE(moved) << moved.error().message << edit.text();
        } else {
            const auto repeated = edit.set(path, old);
            ASSERT_TRUE(repeated) << repeated.error().message << edit.text();
        }
        EXPECT_EQ(edit.value(), before) << edit.text();
    }

    void add(TomlEditor& edit, const TomlPath& path, const json& old) {
        const json before = edit.value();
        json expected_value = before;
        TomlPath added = path;
        if (old.is_array()) {
            added = below(path, old.size());
            const json value = old.empty() ? json(1) : any(old);
            const auto done = edit.add(path, value);
            ASSERT_TRUE(done) << done.error().message;
            expected_value.at(pointer(path)).push_back(value);
        } else if (old.is_object()) {
            added = below(path, "a new key");
            const json value = other_value();
            const auto done = edit.set(added, value);
            ASSERT_TRUE(done) << done.error().message;
            expected_value.at(pointer(path))["a new key"] = value;
        } else {
            return;
        }
        EXPECT_EQ(edit.value(), expected_value) << edit.text();
        EXPECT_LE(lost_lines(text_, edit.text()), 1U) << edit.text();
        const auto taken = edit.remove(added);
        ASSERT_TRUE(taken) << taken.error().message;
        EXPECT_EQ(edit.value(), before) << edit.text();
        EXPECT_EQ(lost_lines(text_, edit.text()), 0U) << edit.text();
    }

    void move(TomlEditor& edit, const TomlPath& path, const json& before) {
        if (!std::holds_alternative<std::size_t>(path.back())) return;
        const TomlPath list(path.begin(), path.end() - 1);
        const std::size_t from = std::get<std::size_t>(path.back());
        const std::size_t to = random_() % before.at(pointer(list)).size();
        const auto done = edit.move(path, to);
        ASSERT_TRUE(done) << done.error().message;
        json expected_value = before;
        json& elements = expected_value.at(pointer(list));
        const json moved = elements[from];
        elements.erase(from);
        elements.insert(elements.begin() + static_cast<std::ptrdiff_t>(to), moved);
        EXPECT_EQ(edit.value(), expected_value) << edit.text();
        const auto back = edit.move(below(list, to), from);
        ASSERT_TRUE(back) << back.error().message;
        EXPECT_EQ(edit.value(), before);
        EXPECT_EQ(lost_lines(text_, edit.text()), 0U) << edit.text();
    }

    std::string text_;
    std::mt19937 random_;
    std::vector<TomlPath> paths_;
};

/// Each of ten numbers has a comment above it, or after it, or none.
TEST(RandomTomlEdits, KeepCommentsWithListElements) {
    std::mt19937 random(11);
    for (int i = 0; i < 200 && !testing::Test::HasFailure(); ++i) {
        std::string text = "a = [\n";
        for (int n = 0; n < 10; ++n) {
            if (random() % 3 == 0) text += fmt::format("  # above {}\n", n);
            text += fmt::format("  {},{}\n", n, random() % 2 == 0 ? "" : fmt::format(" # behind {}", n));
        }
        auto edit = TomlEditor::read(text + "]\n", "list");
        ASSERT_TRUE(edit);
        ordered_json value = ordered_json::array({10});
        for (int n = 0; n < 10; ++n) {
            if (random() % 3 == 0) continue;
            value.insert(value.begin() + static_cast<std::ptrdiff_t>(random() % (value.size() + 1)), n);
        }
        ASSERT_TRUE(edit->set({"a"}, value));
        SCOPED_TRACE(text + value.dump() + edit->text());
        EXPECT_EQ(edit->value(), json({{"a", json(value)}}));
        // A value that has replaced another one has that one's comment.
        for (const std::string& line : lines(edit->text())) {
            const std::size_t at = line.find(", # behind ");
            if (at == std::string::npos || line.starts_with("  10,")) continue;
            EXPECT_EQ(line.substr(2, at - 2), line.substr(at + 11));
        }
        for (const auto& each : value) {
            const std::string with_comment = fmt::format("  {}, # behind {}\n", each.dump(), each.dump());
            const bool had = text.find(with_comment) != std::string::npos;
            EXPECT_EQ(edit->text().find(with_comment) != std::string::npos, had) << each;
        }
    }
}

TEST(RandomTomlEdits, SetExpectedValuesAndKeepOtherLinesOfSamples) {
    constexpr int kEditsEach = 60;
    ASSERT_GT(samples().size(), 15U);
    for (const auto& file : samples()) {
        std::string text = read_file_text(file);
        for (const bool crlf : {false, true}) {
            SCOPED_TRACE(fmt::format("{}, {}", file.string(), crlf ? "CRLF" : "LF"));
            if (crlf) {
                std::string converted;
                for (const char c : text) converted += c == '\n' ? std::string("\r\n") : std::string(1, c);
                text = converted;
            }
            RandomEdits edits(text, 7);
            for (int i = 0; i < kEditsEach && !testing::Test::HasFailure(); ++i) {
                SCOPED_TRACE(i);
                edits.try_one();
            }
        }
    }
}

}  // namespace
}  // namespace gsim::base
