#include "calibrate/times/motion_record.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "base/text/trimmed.h"
#include "calibrate/text/halsampler.h"
#include "calibrate/text/list.h"
#include "calibrate/times/log_timestamp.h"

namespace gsim::calibrate {

namespace {

using Samples = Result<std::vector<MotionSample>>;

constexpr std::string_view kRecordBlanks = " \t\r\"";

std::optional<double> parse_trimmed_number(std::string_view text) {
    return parse_number(text::trimmed(text, kRecordBlanks));
}

/// Returns 0, 1, 2 for x, y, z; -1 for other letters.
int axis_index(char letter) {
    const char lower = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return lower >= 'x' && lower <= 'z' ? lower - 'x' : -1;
}

/// Collector of samples with rising times.
class SampleList {
  public:
    void add(double t_s, const Eigen::Vector3d& at_mm) {
        if (samples_.empty() || t_s > samples_.back().t_s) samples_.push_back({t_s, at_mm});
    }
    Samples release_samples() {
        if (samples_.size() < 2) return Unexpected("it has fewer than two samples");
        return std::move(samples_);
    }

  private:
    std::vector<MotionSample> samples_;
};

/// Calls `on_line` with the number of each line that is not empty, and the line; stops if it returns false.
template <typename Visitor>
bool for_each_line(std::string_view text, const Visitor& on_line) {
    for (int number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text::trimmed(text.substr(0, end), kRecordBlanks);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (!line.empty() && !on_line(number, line)) return false;
    }
    return true;
}

// Format CSV.

struct CsvColumns {
    std::size_t time = std::string_view::npos;
    std::array<std::size_t, 3> axes{std::string_view::npos, std::string_view::npos, std::string_view::npos};
};

std::optional<CsvColumns> csv_columns(std::string_view line, std::string_view separators) {
    CsvColumns columns;
    const auto names = split_cells(line, separators);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string_view name = text::trimmed(names[i], kRecordBlanks);
        if (name == "t_s" || name == "time_s" || name == "t") columns.time = i;
        const int axis = name.empty() ? -1 : axis_index(name.front());
        if (axis >= 0 && (name.size() == 1 || name.substr(1) == "_mm"))
            columns.axes[static_cast<std::size_t>(axis)] = i;
    }
    const bool any = std::any_of(columns.axes.begin(), columns.axes.end(),
                                 [](std::size_t at) { return at != std::string_view::npos; });
    if (columns.time == std::string_view::npos || !any) return std::nullopt;
    return columns;
}

std::optional<MotionSample> csv_sample(const Cells& cells, const CsvColumns& columns) {
    const auto cell = [&](std::size_t at) -> std::optional<double> {
        if (at >= cells.size()) return std::nullopt;
        return parse_trimmed_number(cells[at]);
    };
    const auto time = cell(columns.time);
    if (!time) return std::nullopt;
    MotionSample sample{*time, Eigen::Vector3d::Zero()};
    for (std::size_t i = 0; i < 3; ++i) {
        if (columns.axes[i] == std::string_view::npos) continue;
        const auto value = cell(columns.axes[i]);
        if (!value) return std::nullopt;
        sample.at_mm[static_cast<Eigen::Index>(i)] = *value;
    }
    return sample;
}

Samples read_csv(std::string_view text) {
    SampleList samples;
    std::optional<CsvColumns> columns;
    std::string_view separators = ",";
    std::string error_text;
    for_each_line(text, [&](int number, std::string_view line) {
        if (!columns) {
            if (line.find(',') == std::string_view::npos) separators = "\t;";
            columns = csv_columns(line, separators);
            if (!columns) error_text = "line 1 must name the columns: t_s, and x_mm, y_mm or z_mm";
            return columns.has_value();
        }
        const auto sample = csv_sample(split_cells(line, separators), *columns);
        if (sample) {
            samples.add(sample->t_s, sample->at_mm);
        } else {
            error_text = fmt::format("line {}: a number is missing", number);
        }
        return sample.has_value();
    });
    if (!error_text.empty()) return tl::unexpected(error_text);
    return samples.release_samples();
}

// Format halsampler.

Samples read_columns(std::string_view text, const RecordFormat& record_format) {
    SampleList samples;
    const auto release_samples = [&](int line, double t_s, const Cells& columns) -> Result<void> {
        if (columns.size() != record_format.columns.size()) {
            return Unexpected(fmt::format("line {}: {} columns, but '{}' is expected (--sample-columns)",
                                          line, columns.size(), record_format.columns));
        }
        Eigen::Vector3d at_mm = Eigen::Vector3d::Zero();
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const int axis = axis_index(record_format.columns[i]);
            const auto value = parse_trimmed_number(columns[i]);
            if (axis < 0) continue;
            if (!value) return Unexpected(fmt::format("line {}: '{}' is not a number", line, columns[i]));
            at_mm[axis] = *value;
        }
        samples.add(t_s, at_mm);
        return {};
    };
    if (auto read =
            read_halsampler(text, record_format.columns.size(), record_format.period_s, release_samples);
        !read)
        return tl::unexpected(read.error());
    return samples.release_samples();
}

// Format grbl.

std::optional<Eigen::Vector3d> grbl_field(std::string_view report, std::string_view name) {
    const std::size_t at = report.find(name);
    if (at == std::string_view::npos) return std::nullopt;
    report.remove_prefix(at + name.size());
    const auto cells = split_cells(report.substr(0, report.find_first_of("|>")), ",");
    Eigen::Vector3d values = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < std::min<std::size_t>(cells.size(), 3); ++i) {
        const auto value = parse_trimmed_number(cells[i]);
        if (!value) return std::nullopt;
        values[static_cast<Eigen::Index>(i)] = *value;
    }
    return values;
}

Samples read_grbl(std::string_view text) {
    SampleList samples;
    std::string error_text;
    Eigen::Vector3d offset_mm = Eigen::Vector3d::Zero();
    for_each_line(text, [&](int number, std::string_view line) {
        const std::size_t at = line.find('<');
        if (at == std::string_view::npos) return true;  // what else a sender writes
        const std::string_view report = line.substr(at);
        if (const auto offset = grbl_field(report, "WCO:")) offset_mm = *offset;
        auto at_mm = grbl_field(report, "MPos:");
        if (const auto work = grbl_field(report, "WPos:"); !at_mm && work) at_mm = *work + offset_mm;
        if (!at_mm) return true;
        const auto t_s = consume_time_s(line);
        if (!t_s) {
            error_text = fmt::format(
                "line {}: a status report must begin with a time, such as 12.345 or 12:34:56.789", number);
            return false;
        }
        samples.add(*t_s, *at_mm);
        return true;
    });
    if (!error_text.empty()) return tl::unexpected(error_text);
    return samples.release_samples();
}

// Format MTConnect.

/// Returns the axis for "Xact", "X_pos", "x"; -1 if the name is no position of x, y or z.
int mtconnect_axis(std::string_view name) {
    if (name.empty()) return -1;
    std::string_view remaining = name.substr(1);
    while (!remaining.empty() && (remaining.front() == '_' || remaining.front() == '-'))
        remaining.remove_prefix(1);
    for (const std::string_view known : {"", "act", "abs", "pos", "position", "actual"}) {
        if (remaining == known) return axis_index(name.front());
    }
    return -1;
}

/// Converter of changes of one axis at a time to samples: the other axes keep their last value.
class Changes {
  public:
    void add(double t_s, int axis, double value_mm) { changes_[t_s].emplace_back(axis, value_mm); }

    Samples release_samples() const {
        SampleList samples;
        Eigen::Vector3d at_mm = Eigen::Vector3d::Zero();
        for (const auto& [t_s, values] : changes_) {
            for (const auto& [axis, value_mm] : values) at_mm[axis] = value_mm;
            samples.add(t_s, at_mm);
        }
        return samples.release_samples();
    }

  private:
    std::map<double, std::vector<std::pair<int, double>>> changes_;
};

Samples read_shdr(std::string_view text) {
    Changes changes;
    for_each_line(text, [&](int /*number*/, std::string_view line) {
        const auto t_s = consume_time_s(line);
        if (!t_s) return true;
        const auto cells = split_cells(line, "|");
        for (std::size_t i = 1; i + 1 < cells.size(); i += 2) {
            const int axis = mtconnect_axis(text::trimmed(cells[i], kRecordBlanks));
            const auto value = parse_trimmed_number(cells[i + 1]);
            if (axis >= 0 && value) changes.add(*t_s, axis, *value);
        }
        return true;
    });
    return changes.release_samples();
}

std::string_view attribute(std::string_view element, std::string_view name) {
    const std::string pattern = fmt::format(" {}=\"", name);
    const std::size_t at = element.find(pattern);
    if (at == std::string_view::npos) return {};
    element.remove_prefix(at + pattern.size());
    return element.substr(0, element.find('"'));
}

Samples read_streams(std::string_view text) {
    Changes changes;
    constexpr std::string_view kElement = "<Position ";
    for (std::size_t at = text.find(kElement); at != std::string_view::npos;
         at = text.find(kElement, at + 1)) {
        const std::size_t end = text.find('>', at);
        if (end == std::string_view::npos) break;
        const std::string_view element = text.substr(at, end - at);
        if (attribute(element, "subType") == "COMMANDED") continue;
        int axis = mtconnect_axis(attribute(element, "name"));
        if (axis < 0) axis = mtconnect_axis(attribute(element, "dataItemId"));
        std::string_view timestamp = attribute(element, "timestamp");
        const auto t_s = consume_time_s(timestamp);
        const auto value = parse_trimmed_number(text.substr(end + 1, text.find('<', end) - end - 1));
        if (axis >= 0 && t_s && value) changes.add(*t_s, axis, *value);
    }
    return changes.release_samples();
}

}  // namespace

Samples read_motion_record(std::string_view text, const RecordFormat& record_format) {
    const std::size_t start = text.find_first_not_of(" \t\r\n");
    if (start == std::string_view::npos) return Unexpected("it is empty");
    if (text.find("Pos:") != std::string_view::npos) return read_grbl(text);
    if (text.substr(start, 5) == "<?xml" || text.find("<Position ") != std::string_view::npos)
        return read_streams(text);
    const std::string_view first = text.substr(start, text.find('\n', start) - start);
    std::string_view remaining = first;
    if (consume_time_s(remaining) && !remaining.empty() && remaining.front() == '|') return read_shdr(text);
    return is_halsampler(first) ? read_columns(text, record_format) : read_csv(text);
}

}  // namespace gsim::calibrate
