#include "studio/engine/compact_message.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <span>
#include <stdexcept>
#include <vector>

#include "base/text/json.h"
#include "studio/engine/message.h"

namespace gsim::studio {

namespace {

using nlohmann::json;

constexpr std::size_t kHeaderBytes = 8;

std::size_t align_up(std::size_t size) {
    return (size + kHeaderBytes - 1) / kHeaderBytes * kHeaderBytes;
}

std::size_t header_size(std::string_view message) {
    std::uint32_t size = 0;
    if (message.size() >= kHeaderBytes) std::memcpy(&size, message.data() + kHeaderBytes / 2, sizeof size);
    if (kHeaderBytes + size > message.size()) throw std::invalid_argument("a message ends within its header");
    return size;
}

/// Returns the header of a message of segments; null for another message.
json segments_header(std::string_view message) {
    json header = text::try_parse_json<json>(message.substr(kHeaderBytes, header_size(message)));
    if (!header.is_object()) throw std::invalid_argument("a message has no header");
    return header.value("is", "") == "segments" ? header : json();
}

/// Columns by their names, at their position in the message.
class Columns {
  public:
    Columns(std::string_view message, const json& header) {
        static const std::map<std::string, std::size_t> kTypeSizes{
            {"f64", 8}, {"f32", 4}, {"u32", 4}, {"u8", 1}};
        std::size_t at = align_up(kHeaderBytes + header_size(message));
        for (const json& column : header.at("columns")) {
            const std::size_t size = kTypeSizes.at(column.at(1)) * column.at(2).get<std::size_t>();
            if (at + size > message.size()) throw std::invalid_argument("a message ends within a column");
            columns_[column.at(0)] = message.substr(at, size);
            at += align_up(size);
        }
    }

    template <typename Value>
    std::span<const Value> get(const char* name) const {
        const std::string_view bytes = columns_.at(name);  // at a multiple of 8
        return {reinterpret_cast<const Value*>(bytes.data()), bytes.size() / sizeof(Value)};
    }

  private:
    std::map<std::string, std::string_view> columns_;
};

// The appearance uses the upper half of an entry of vertex_segment.
constexpr std::size_t kMaxSegments = std::size_t{1} << 16U;
constexpr int kSpeedsPerOctave = 8;
constexpr int kCodeOfOneMmPerSecond = 17;
constexpr int kMaxSpeedCode = 127;

/// Returns the mean speed along the path in steps of an eighth of an octave, as a page draws it; 0: no
/// motion.
std::uint32_t speed_code(double length_mm, double duration_s) {
    if (!(length_mm > 0 && duration_s > 0)) return 0;
    const double steps =
        std::round(kSpeedsPerOctave * std::log2(length_mm / duration_s)) + kCodeOfOneMmPerSecond;
    return static_cast<std::uint32_t>(std::clamp(steps, 1.0, static_cast<double>(kMaxSpeedCode)));
}

/// Returns the appearance of each segment: move, limit, process and mean speed, in bits 16 to 31.
std::vector<std::uint32_t> segment_styles(const Columns& columns) {
    const auto flags = columns.get<std::uint32_t>("flags");
    const auto length_mm = columns.get<double>("length_mm");
    const auto duration_s = columns.get<double>("duration_s");
    std::vector<std::uint32_t> styles(flags.size());
    for (std::size_t i = 0; i < styles.size(); ++i) {
        const std::uint32_t move_and_limit = flags[i] >> 8U & 0xffU;
        const std::uint32_t process_on = flags[i] >> 2U & 1U;
        styles[i] = (move_and_limit | process_on << 8U | speed_code(length_mm[i], duration_s[i]) << 9U)
                    << 16U;
    }
    return styles;
}

/// Returns the times of vertices since the message's start. On the clock of a long run 32 bits cannot
/// distinguish two blocks.
std::vector<float> vertex_times(const Columns& columns) {
    const auto start_s = columns.get<double>("start_s");
    const auto duration_s = columns.get<double>("duration_s");
    const auto vertex_s = columns.get<float>("vertex_s");
    const auto segments = columns.get<std::uint32_t>("vertex_segment");
    std::vector<float> times;
    times.reserve(vertex_s.size());
    for (std::size_t i = 0; i < vertex_s.size(); ++i) {
        const std::size_t segment = segments[i];
        if (segment >= start_s.size()) {  // no motion
            times.push_back(0);
            continue;
        }
        const double end_s = start_s[segment] + duration_s[segment];
        const bool ends = i + 1 == vertex_s.size() || segments[i + 1] != segment;
        const double time_s =
            ends ? end_s : std::clamp(static_cast<double>(vertex_s[i]), start_s[segment], end_s);
        times.push_back(static_cast<float>(time_s - start_s.front()));
    }
    return times;
}

/// Returns stretches of segments of one file with lines that advance by the same step: for each its first
/// segment, the file, the first line and the step (modulo 2^32).
std::vector<std::uint32_t> source_lines(const Columns& columns) {
    const auto line = columns.get<std::uint32_t>("line");
    const auto file = columns.get<std::uint32_t>("file");
    std::vector<std::uint32_t> lines;
    for (std::size_t first = 0; first < line.size();) {
        std::size_t end = first + 1;
        const std::uint32_t step =
            end < line.size() && file[end] == file[first] ? line[end] - line[first] : 0;
        while (end < line.size() && file[end] == file[first] && line[end] - line[end - 1] == step) ++end;
        lines.insert(lines.end(), {static_cast<std::uint32_t>(first), file[first], line[first], step});
        first = end;
    }
    return lines;
}

}  // namespace

std::optional<std::string> compact_message(std::string_view message) {
    const json header = segments_header(message);
    if (header.is_null()) return std::nullopt;
    const Columns columns(message, header);
    const auto start_s = columns.get<double>("start_s");
    const auto duration_s = columns.get<double>("duration_s");
    if (start_s.size() > kMaxSegments) throw std::invalid_argument("a message has too many segments");
    Message compact("segments");
    auto& compact_header = compact.header();
    compact_header.update({{"lean", true},
                           {"robot", header.at("robot")},
                           {"first", header.at("first")},
                           {"count", start_s.size()}});
    if (!start_s.empty()) {
        compact_header.update({{"start_s", start_s.front()}, {"end_s", start_s.back() + duration_s.back()}});
    }
    const auto styles = segment_styles(columns);
    const auto segments = columns.get<std::uint32_t>("vertex_segment");
    std::vector<std::uint32_t> packed(segments.begin(), segments.end());
    for (std::uint32_t& segment : packed) {
        if (segment < styles.size()) segment |= styles[segment];
    }
    compact.add("vertex_mm", columns.get<float>("vertex_mm"));
    compact.add("vertex_s", vertex_times(columns));
    compact.add("vertex_segment", packed);
    compact.add("lines", source_lines(columns));
    return compact.bytes();
}

std::optional<std::uint64_t> first_segment(std::string_view message) {
    const json header = segments_header(message);
    if (header.is_null()) return std::nullopt;
    return header.at("first").get<std::uint64_t>();
}

}  // namespace gsim::studio
