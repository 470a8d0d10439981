#include "calibrate/servo/servo_record.h"

#include <algorithm>
#include <cctype>
#include <optional>

#include <fmt/format.h>

#include "calibrate/text/halsampler.h"
#include "calibrate/text/list.h"

namespace gsim::calibrate {

namespace {

using Records = Result<std::vector<AxisRecord>>;

constexpr std::string_view kLineBlanks = " \t\r\n";
constexpr std::size_t kMinSamples = 20;

char upper(char letter) {
    return static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
}

bool is_letter(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

/// Columns of the numbers of an axis in a line.
struct AxisColumns {
    char letter = 'X';
    std::size_t set_point = 0;
    std::size_t other = 0;  ///< Its position, or its error.
    bool is_error = false;
};

/// Collector of samples, a line each.
class AxisSamples {
  public:
    explicit AxisSamples(std::vector<AxisColumns> columns) : columns_(std::move(columns)) {
        for (const AxisColumns& axis : columns_) records_.push_back({axis.letter, {}, {}, {}});
    }

    /// Adds a sample. False: a number is missing.
    bool add(double t_s, const Cells& cells) {
        std::vector<double> values;
        for (const AxisColumns& axis : columns_) {
            if (std::max(axis.set_point, axis.other) >= cells.size()) return false;
            const auto set_point = parse_number(cells[axis.set_point]),
                       other = parse_number(cells[axis.other]);
            if (!set_point || !other) return false;
            values.push_back(*set_point);
            values.push_back(axis.is_error ? *set_point - *other : *other);
        }
        if (!records_.front().t_s.empty() && t_s <= records_.front().t_s.back()) return true;
        for (std::size_t i = 0; i < records_.size(); ++i) {
            records_[i].t_s.push_back(t_s);
            records_[i].set_points.push_back(values[2 * i]);
            records_[i].positions.push_back(values[2 * i + 1]);
        }
        return true;
    }

    Records release_records() {
        if (records_.front().t_s.size() < kMinSamples)
            return Unexpected(fmt::format("it has fewer than {} samples", kMinSamples));
        return std::move(records_);
    }

  private:
    std::vector<AxisColumns> columns_;
    std::vector<AxisRecord> records_;
};

/// Returns axes with both a set point and a position or error.
std::vector<AxisColumns> named_columns(const Cells& heading) {
    std::vector<AxisColumns> found;
    for (std::size_t i = 0; i < heading.size(); ++i) {
        const std::string_view name = heading[i];
        if (name.size() < 2 || !is_letter(name.front())) continue;
        const std::string_view unit = name.substr(1);
        if (unit != "_mm" && unit != "_deg") continue;
        for (const std::string_view what : {"_at", "_error"}) {
            const auto other = find_column(heading, fmt::format("{}{}{}", name.front(), what, unit));
            if (!other) continue;
            found.push_back({upper(name.front()), i, *other, what == "_error"});
            break;
        }
    }
    return found;
}

Records read_named(std::string_view text) {
    std::optional<AxisSamples> samples;
    std::size_t time = 0;
    const auto heading = [&](const Cells& cells) -> Result<void> {
        const auto at = find_column(cells, "t_s");
        auto columns = named_columns(cells);
        if (!at || columns.empty()) {
            return Unexpected(
                "the columns must be t_s and two for each axis: its set point x_mm, and its actual position "
                "x_at_mm or its following error x_error_mm");
        }
        time = *at;
        samples.emplace(std::move(columns));
        return {};
    };
    const auto row = [&](const Cells& cells) -> Result<void> {
        const auto t_s = time < cells.size() ? parse_number(cells[time]) : std::nullopt;
        if (!t_s || !samples->add(*t_s, cells)) return Unexpected("a number is missing");
        return {};
    };
    if (const auto read = read_list(text, heading, row); !read) return tl::unexpected(read.error());
    return samples->release_records();
}

/// Pairs capital letters with the same small ones.
std::vector<AxisColumns> columns_from_letters(std::string_view columns) {
    std::vector<AxisColumns> found;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const char letter = columns[i];
        if (!is_letter(letter) || upper(letter) != letter) continue;
        const char lower_letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
        if (const std::size_t other = columns.find(lower_letter); other != std::string_view::npos)
            found.push_back({letter, i, other, false});
    }
    return found;
}

Records read_columns(std::string_view text, const ServoFormat& columns_format) {
    auto columns = columns_from_letters(columns_format.columns);
    if (columns_format.period_s > 0 && columns.empty()) {
        return Unexpected(
            fmt::format("'{}' has no axis with both its set point (X) and its actual position (x)",
                        columns_format.columns));
    }
    AxisSamples samples(std::move(columns));
    const auto release_records = [&](int line, double t_s, const Cells& words) -> Result<void> {
        if (words.size() == columns_format.columns.size() && samples.add(t_s, words)) return {};
        return Unexpected(fmt::format("line {}: it must have the {} numbers of '{}' (--sample-columns)", line,
                                      columns_format.columns.size(), columns_format.columns));
    };
    if (auto read =
            read_halsampler(text, columns_format.columns.size(), columns_format.period_s, release_records);
        !read)
        return tl::unexpected(read.error());
    return samples.release_records();
}

}  // namespace

Records read_servo_record(std::string_view text, const ServoFormat& columns_format) {
    const std::size_t start = text.find_first_not_of(kLineBlanks);
    if (start == std::string_view::npos) return Unexpected("it is empty");
    const bool numbers = is_halsampler(text.substr(start, text.find('\n', start) - start));
    return numbers ? read_columns(text, columns_format) : read_named(text.substr(start));
}

}  // namespace gsim::calibrate
