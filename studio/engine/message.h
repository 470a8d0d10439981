#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/text/json.h"

namespace gsim::studio {

/// Format of messages (docs/versions.md). It rises if a page of before would misunderstand a new message.
inline constexpr int kMessageFormat = 1;

/// Message of the engine to a page: a header in JSON, followed by columns of numbers that a page reads
/// without a copy. docs/studio.md has the layout.
class Message {
  public:
    /// `is`: its type, "segments".
    explicit Message(const char* is) : header_{{"format", kMessageFormat}, {"is", is}} {}

    nlohmann::ordered_json& header() { return header_; }
    void add(const char* name, std::span<const double> values) { write(name, "f64", values); }
    void add(const char* name, std::span<const float> values) { write(name, "f32", values); }
    void add(const char* name, std::span<const std::uint32_t> values) { write(name, "u32", values); }
    void add(const char* name, const std::string& bytes) {
        write(name, "u8", std::span<const char>(bytes.data(), bytes.size()));
    }

    /// Returns the bytes: their number and that of the header's (both 32 bits, little-endian), the header,
    /// and each column; header and columns begin at multiples of 8. Throws std::length_error past 4 GB.
    std::string bytes() const;

  private:
    template <typename Value>
    void write(const char* name, const char* type, std::span<const Value> values) {
        header_["columns"].push_back({name, type, values.size()});
        parts_.emplace_back(reinterpret_cast<const char*>(values.data()), values.size_bytes());
    }

    nlohmann::ordered_json header_;
    std::vector<std::string> parts_;
};

}  // namespace gsim::studio
