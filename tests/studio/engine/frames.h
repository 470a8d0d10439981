#pragma once

#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "base/text/json.h"

namespace gsim::studio {

/// A message as a page reads it.
struct Frame {
    nlohmann::json header;
    std::map<std::string, std::string> columns;

    std::string is() const { return header.at("is"); }
    template <typename Value>
    std::vector<Value> column(const std::string& name) const {
        const std::string& bytes = columns.at(name);
        std::vector<Value> values(bytes.size() / sizeof(Value));
        if (!bytes.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
        return values;
    }
};

inline std::uint32_t number_at(const std::string& bytes, std::size_t at) {
    std::uint32_t number = 0;
    std::memcpy(&number, bytes.data() + at, sizeof number);
    return number;
}

/// By docs/studio.md, not by what wrote it.
inline Frame read_frame(const std::string& bytes) {
    const auto aligned = [](std::size_t size) { return (size + 7) / 8 * 8; };
    const std::map<std::string, std::size_t> sizes{{"f64", 8}, {"f32", 4}, {"u32", 4}, {"u8", 1}};
    Frame frame;
    const std::size_t header = number_at(bytes, 4);
    frame.header = text::parse_json<nlohmann::json>(bytes.substr(8, header));
    std::size_t at = aligned(8 + header);
    for (const auto& column : frame.header.value("columns", nlohmann::json::array())) {
        const std::size_t size = sizes.at(column[1]) * column[2].get<std::size_t>();
        frame.columns[column[0]] = bytes.substr(at, size);
        at += aligned(size);
    }
    return frame;
}

}  // namespace gsim::studio
