#include "codegen/post/post_file.h"

#include <algorithm>
#include <array>

#include "base/os/input_file.h"
#include "base/text/format.h"
#include "base/toml/toml_section.h"
#include "codegen/post/action_blocks.h"
#include "codegen/post/embedded_posts.h"

namespace gsim::codegen {

namespace {

using base::FirstError;
using base::NumberRule;
using base::TomlSection;
using Names = std::span<const std::string_view>;

constexpr std::string_view kExtension = ".toml";
constexpr int kMaxDecimals = 6;
constexpr int kMaxDigits = 9;

constexpr std::array<std::string_view, 14> kPostKeys = {
    "name",    "reads_as",     "numbers",    "blocks",  "arcs",        "program",          "subprogram",
    "actions", "acceleration", "feed_modes", "offsets", "tool_change", "reference_points", "probe"};
constexpr std::array<std::string_view, 3> kArcKeys = {"through_point", "oblique", "turns"};
constexpr std::array<std::string_view, 2> kObliqueArcRules = {"lines", "refuse"};
constexpr std::array<std::string_view, 6> kNumberKeys = {
    "decimals_mm", "decimals_inch", "decimals_deg", "decimals_feed", "decimals_recorded_mm", "zeros"};
constexpr std::array<std::string_view, 7> kBlockKeys = {
    "number_step", "number_digits", "axes", "dwell", "start_position", "thread", "thread_lead"};
constexpr std::array<std::string_view, 4> kFeedModeKeys = {"per_minute", "inverse_time", "per_revolution",
                                                           "inverse_time_of_arcs"};
constexpr std::array<std::string_view, 7> kOffsetKeys = {"system", "systems", "set", "machine",
                                                         "here",   "begin",   "end"};
constexpr std::array<std::string_view, 2> kReferenceKeys = {"go", "end"};
constexpr std::array<std::string_view, 1> kReferencePlaceholders = {"axes"};
constexpr std::size_t kMaxReferences = 4;
constexpr std::array<std::string_view, 1> kProbeKeys = {"touch"};
constexpr std::array<std::string_view, 7> kTouchPlaceholders = {"axis",  "number", "to",     "feed",
                                                                "index", "system", "surface"};
constexpr std::array<std::string_view, 3> kRequiredTouchPlaceholders = {"axis", "to", "surface"};
constexpr std::array<std::string_view, 1> kToolChangeKeys = {"stops"};
constexpr std::array<std::string_view, 2> kStoppableOutputs = {"spindle", "coolant"};
constexpr std::array<std::string_view, 2> kInverseTimeUnits = {"move", "radian"};
constexpr std::array<std::string_view, 1> kSystemPlaceholders = {"system"};
constexpr std::array<std::string_view, 4> kSetPlaceholders = {"index", "x", "y", "z"};
constexpr std::array<std::string_view, 2> kProgramKeys = {"begin", "end"};
constexpr std::array<std::string_view, 6> kSubprogramKeys = {"order", "begin",         "end",
                                                             "call",  "call_repeated", "file"};
constexpr std::array<std::string_view, 2> kAccelerationKeys = {"set", "end"};
constexpr std::array<std::string_view, 2> kOrders = {"after", "before"};
constexpr std::array<std::string_view, 3> kTrailingZeroRules = {"keep", "point", "cut"};
constexpr std::array<std::string_view, 2> kDialects = {"ab9", "rs274ngc"};

constexpr std::array<std::string_view, 5> kProgramPlaceholders = {"number", "title", "program", "lower",
                                                                  "unit"};
constexpr std::array<std::string_view, 5> kCallPlaceholders = {"number", "program", "lower", "repeats",
                                                               "label"};
constexpr std::array<std::string_view, 3> kFilePlaceholders = {"number", "program", "lower"};
constexpr std::string_view kFileCharacters =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.";
constexpr std::size_t kMaxFileNameLength = 100;
constexpr std::array<std::string_view, 2> kDwellPlaceholders = {"seconds", "milliseconds"};
constexpr std::array<std::string_view, 1> kAccelerationPlaceholders = {"acceleration"};

class PostReader {
  public:
    explicit PostReader(std::string_view file_name) : error_(file_name) {}

    Result<Post> read(std::string_view text) {
        const toml::table table = base::parse_toml(error_, text);
        if (!error_.text()) read_post(table);
        if (error_.text()) return tl::unexpected(*error_.text());
        return std::move(post_);
    }

  private:
    void read_post(const toml::table& table) {
        TomlSection section(error_, table, "the post", kPostKeys);
        post_.name = section.text("name");
        section.require("reads_as");
        post_.dialect = kDialects[section.choice("reads_as", 0, kDialects)];
        if (const auto* numbers = section_table(section, "numbers")) read_numbers(*numbers);
        if (const auto* blocks = section_table(section, "blocks")) read_blocks(*blocks);
        if (const auto* arcs = section.table("arcs")) read_arcs(*arcs);
        if (const auto* program = section_table(section, "program")) {
            TomlSection of(error_, *program, "[program]", kProgramKeys);
            post_.begin = lines(of, "begin", kProgramPlaceholders);
            post_.end = lines(of, "end", kProgramPlaceholders);
        }
        if (const auto* subprogram = section.table("subprogram")) read_subprogram(*subprogram);
        if (const auto* acceleration = section.table("acceleration")) {
            TomlSection of(error_, *acceleration, "[acceleration]", kAccelerationKeys);
            post_.acceleration.set = lines(of, "set", kAccelerationPlaceholders);
            post_.acceleration.end = lines(of, "end", {});
        }
        if (const auto* modes = section.table("feed_modes")) read_feed_modes(*modes);
        if (const auto* offsets = section.table("offsets")) read_offsets(*offsets);
        if (const auto* change = section.table("tool_change")) read_tool_change(*change);
        if (const auto* references = section.table("reference_points")) read_references(*references);
        if (const auto* probe = section.table("probe")) read_probe(*probe);
        if (const auto* actions = section.table("actions")) read_actions(*actions);
    }

    const toml::table* section_table(TomlSection& section, std::string_view key) {
        section.require(key);
        return section.table(key);
    }

    int read_integer(TomlSection& section, std::string_view key, int max) {
        if (section.require(key) == nullptr) return 0;
        const double value = section.number(key, 0, NumberRule::not_negative);
        if (value <= max && value == std::floor(value)) return static_cast<int>(value);
        section.fail(key, fmt::format("'{}' must be an integer from 0 to {}", key, max));
        return 0;
    }

    void read_numbers(const toml::table& table) {
        TomlSection section(error_, table, "[numbers]", kNumberKeys);
        post_.numbers.decimals_mm = read_integer(section, "decimals_mm", kMaxDecimals);
        post_.numbers.decimals_inch = read_integer(section, "decimals_inch", kMaxDecimals);
        post_.numbers.decimals_deg = read_integer(section, "decimals_deg", kMaxDecimals);
        post_.numbers.decimals_feed = read_integer(section, "decimals_feed", kMaxDecimals);
        if (section.has("decimals_recorded_mm"))
            post_.numbers.decimals_recorded_mm = read_integer(section, "decimals_recorded_mm", kMaxDecimals);
        section.require("zeros");
        post_.numbers.zeros = static_cast<TrailingZeros>(section.choice("zeros", 0, kTrailingZeroRules));
    }

    void read_blocks(const toml::table& table) {
        TomlSection section(error_, table, "[blocks]", kBlockKeys);
        post_.blocks.number_step = read_integer(section, "number_step", 1000);
        post_.blocks.number_digits = read_integer(section, "number_digits", kMaxDigits);
        if (section.has("axes")) post_.blocks.axes = section.text("axes");
        post_.blocks.dwell = section.text("dwell");
        check_line(section, "dwell", post_.blocks.dwell, kDwellPlaceholders);
        post_.blocks.start_position = word(section, "start_position");
        post_.thread.code = word(section, "thread");
        post_.thread.lead = word(section, "thread_lead");
        if (post_.thread.code.empty() != post_.thread.lead.empty())
            section.fail("thread", "'thread' and 'thread_lead' must be given together");
    }

    // Reads an optional word.
    std::string word(TomlSection& section, std::string_view key, Names placeholders = {}) {
        if (!section.has(key)) return {};
        std::string text = section.text(key);
        check_line(section, key, text, placeholders);
        return text;
    }

    void read_feed_modes(const toml::table& table) {
        TomlSection section(error_, table, "[feed_modes]", kFeedModeKeys);
        section.require("per_minute");
        post_.feed_modes.per_minute = word(section, "per_minute");
        post_.feed_modes.inverse_time = word(section, "inverse_time");
        post_.feed_modes.per_revolution = word(section, "per_revolution");
        post_.feed_modes.inverse_time_by_angle =
            section.choice("inverse_time_of_arcs", 0, kInverseTimeUnits) == 1;
    }

    void read_offsets(const toml::table& table) {
        TomlSection section(error_, table, "[offsets]", kOffsetKeys);
        OffsetWords& words = post_.offsets;
        words.system = word(section, "system", kSystemPlaceholders);
        if (section.has("systems")) words.systems = lines(section, "systems", {});
        words.set = word(section, "set", kSetPlaceholders);
        words.machine = word(section, "machine");
        words.preset = word(section, "here");
        if (section.has("begin")) words.begin = lines(section, "begin", {});
        if (section.has("end")) words.end = lines(section, "end", {});
        if (words.system.empty() != words.systems.empty())
            section.fail("system", "'system' and 'systems' must be given together");
        for (const std::string_view placeholder : kSetPlaceholders) {
            if (words.set.empty() || words.set.find(fmt::format("{{{}}}", placeholder)) != std::string::npos)
                continue;
            section.fail("set",
                         fmt::format("'set' must contain {{{}}}", text::joined(kSetPlaceholders, "}, {")));
        }
    }

    void read_references(const toml::table& table) {
        TomlSection section(error_, table, "[reference_points]", kReferenceKeys);
        post_.references.go = lines(section, "go", kReferencePlaceholders);
        if (section.has("end")) post_.references.end = lines(section, "end", {});
        if (post_.references.go.size() > kMaxReferences)
            section.fail("go", fmt::format("'go' must have a line for each reference point, at most {}",
                                           kMaxReferences));
        for (const std::string& line : post_.references.go) {
            if (line.find("{axes}") == std::string::npos)
                section.fail("go", "each line of 'go' must contain {axes}");
        }
    }

    void read_probe(const toml::table& table) {
        TomlSection section(error_, table, "[probe]", kProbeKeys);
        post_.touch = lines(section, "touch", kTouchPlaceholders);
        const std::string all = text::joined(post_.touch, "\n");
        for (const std::string_view placeholder : kRequiredTouchPlaceholders) {
            if (all.find(fmt::format("{{{}}}", placeholder)) == std::string::npos)
                section.fail("touch", fmt::format("'touch' must contain {{{}}}",
                                                  text::joined(kRequiredTouchPlaceholders, "}, {")));
        }
    }

    void read_tool_change(const toml::table& table) {
        TomlSection section(error_, table, "[tool_change]", kToolChangeKeys);
        for (const std::string& stopped : lines(section, "stops", {})) {
            const auto at = std::find(kStoppableOutputs.begin(), kStoppableOutputs.end(), stopped);
            if (at == kStoppableOutputs.end())
                section.fail("stops", fmt::format("'stops' must contain {}, not \"{}\"",
                                                  text::joined(kStoppableOutputs, " and "), stopped));
            (at == kStoppableOutputs.begin() ? post_.tool_change.stops_spindle
                                             : post_.tool_change.stops_coolant) = true;
        }
    }

    void read_arcs(const toml::table& table) {
        TomlSection section(error_, table, "[arcs]", kArcKeys);
        post_.arcs.rejects_oblique = section.choice("oblique", 0, kObliqueArcRules) == 1;
        post_.arcs.turns_letter = word(section, "turns");
        if (!section.has("through_point")) return;
        std::vector<std::string> words = lines(section, "through_point", {});
        if (words.size() != 4) {
            section.fail("through_point",
                         "'through_point' must have four strings: the code, and the letters of X, Y and Z of "
                         "the point");
            return;
        }
        post_.arcs.through_point = {std::move(words[0]),
                                    {std::move(words[1]), std::move(words[2]), std::move(words[3])}};
    }

    void read_subprogram(const toml::table& table) {
        TomlSection section(error_, table, "[subprogram]", kSubprogramKeys);
        SubprogramLines& subprogram_lines = post_.subprogram.emplace();
        section.require("order");
        subprogram_lines.before_program = section.choice("order", 0, kOrders) == 1;
        subprogram_lines.begin = lines(section, "begin", kProgramPlaceholders);
        subprogram_lines.end = lines(section, "end", kProgramPlaceholders);
        subprogram_lines.call = lines(section, "call", kCallPlaceholders);
        subprogram_lines.call_repeated = lines(section, "call_repeated", kCallPlaceholders);
        subprogram_lines.file = section.text("file");
        check_line(section, "file", subprogram_lines.file, kFilePlaceholders);
        check_file_name(section, subprogram_lines.file);
    }

    // Posts come along with programs of others, so no name may have a special meaning elsewhere. Each
    // subprogram must get a name of its own. The values of placeholders consist only of letters, digits and
    // '_'.
    static void check_file_name(TomlSection& section, std::string_view file) {
        std::string plain(file);
        for (const std::string_view placeholder : kFilePlaceholders) {
            const std::string written = fmt::format("{{{}}}", placeholder);
            for (std::size_t at = plain.find(written); at != std::string::npos; at = plain.find(written))
                plain.replace(at, written.size(), "0");
        }
        const bool known = plain.find_first_not_of(kFileCharacters) == std::string::npos &&
                           plain.find("..") == std::string::npos;
        if (!known || plain.empty() || plain.size() > kMaxFileNameLength || plain[0] == '.' ||
            plain[0] == '-') {
            section.fail("file", fmt::format("'file' must be a name of letters, digits, '_', '-' and '.', of "
                                             "at most {} characters, that begins with a letter, a digit, '_' "
                                             "or a placeholder, such as \"{{program}}_O{{number}}.nc\"",
                                             kMaxFileNameLength));
        } else if (file.find("{number}") == std::string_view::npos) {
            section.fail("file", "'file' must contain {number}, so that each subprogram has a separate file");
        }
    }

    void read_actions(const toml::table& table) {
        for (const auto& [key, node] : table) {
            const auto* text = node.as_string();
            if (text == nullptr) {
                error_.report(node.source().begin, fmt::format("'{}' must be a string", key.str()));
            } else {
                const std::vector<std::string> placeholders = placeholder_names(key.str());
                const std::vector<std::string_view> known(placeholders.begin(), placeholders.end());
                check_text(node.source().begin, key.str(), text->get(), known);
                post_.actions.emplace(key.str(), text->get());
            }
        }
    }

    std::vector<std::string> lines(TomlSection& section, std::string_view key, Names placeholders) {
        std::vector<std::string> found;
        const toml::node* node = section.require(key);
        if (node == nullptr) return found;
        const toml::array* array = node->as_array();
        if (array == nullptr) {
            section.fail(key, fmt::format("'{}' must be an array of strings, one for each line", key));
            return found;
        }
        found.reserve(array->size());
        for (const toml::node& element : *array) {
            const auto* text = element.as_string();
            if (text == nullptr) {
                error_.report(element.source().begin, fmt::format("'{}' must contain only strings", key));
            } else {
                check_text(element.source().begin, key, text->get(), placeholders);
                found.push_back(text->get());
            }
        }
        return found;
    }

    void check_line(TomlSection& section, std::string_view key, std::string_view line, Names placeholders) {
        check_text(section.where(key), key, line, placeholders);
    }

    // Checks that a line is one line, and has no placeholders but these.
    void check_text(const toml::source_position& where, std::string_view key, std::string_view line,
                    Names placeholders) {
        const bool is_control_character = std::any_of(
            line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; });
        if (is_control_character)
            error_.report(where,
                          fmt::format("'{}' must not contain line breaks or other control characters", key));
        for (std::size_t open = line.find('{'); open != std::string_view::npos;
             open = line.find('{', open + 1)) {
            const std::string_view name = line.substr(open + 1, line.find('}', open) - open - 1);
            if (std::find(placeholders.begin(), placeholders.end(), name) != placeholders.end()) continue;
            const std::string hint = placeholders.empty()
                                         ? std::string("nothing")
                                         : fmt::format("{{{}}}", text::joined(placeholders, "}, {"));
            error_.report(where,
                          fmt::format("'{}' has no placeholder {{{}}}; it may contain {}", key, name, hint));
        }
    }

    FirstError error_;
    Post post_;
};

}  // namespace

Result<Post> read_post(std::string_view toml_text, std::string_view file_name) {
    return PostReader(file_name).read(toml_text);
}

std::vector<std::string_view> built_in_posts() {
    std::vector<std::string_view> names;
    names.reserve(embedded::embedded_posts().size());
    for (const auto& [file_name, text] : embedded::embedded_posts()) {
        names.push_back(file_name.substr(0, file_name.size() - kExtension.size()));
    }
    return names;
}

Result<Post> find_post(const std::string& name) {
    if (name.ends_with(kExtension)) {
        const Result<std::string> text = os::read_text_file(name, os::NameSource::command_line);
        if (!text) return tl::unexpected(text.error());
        return read_post(*text, name);
    }
    const std::string_view text = embedded::embedded_posts(name + std::string(kExtension));
    if (text.data() != nullptr) return read_post(text, name);
    return Unexpected(fmt::format("unknown post '{}'; use {}, or a file that ends in {}", name,
                                  text::joined(built_in_posts(), ", "), kExtension));
}

}  // namespace gsim::codegen
