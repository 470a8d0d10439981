#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace gsim::solid {

/// Types for which any bytes are a value; a bool is 0 or 1 only (write_flag()).
template <typename T>
concept PacketValue = std::is_trivially_copyable_v<T> && !std::is_same_v<T, bool>;

/// Writer of consecutive values as bytes, between two programs of one build on one machine.
class PacketWriter {
  public:
    template <PacketValue T>
    void write(const T& value) {
        bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    template <PacketValue T>
    void write_all(const std::vector<T>& values) {
        write(static_cast<std::uint64_t>(values.size()));
        bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
    }
    void write_flag(bool flag) { write(static_cast<std::uint8_t>(flag ? 1 : 0)); }
    void write_text(std::string_view text) {
        write(static_cast<std::uint64_t>(text.size()));
        bytes_.append(text);
    }

    const std::string& bytes() const { return bytes_; }

  private:
    std::string bytes_;
};

/// Reader of the values in the same order. If the bytes do not suffice, values are 0 and empty, and
/// is_complete() is false.
class PacketReader {
  public:
    explicit PacketReader(std::string_view bytes) : remaining_(bytes) {}

    template <PacketValue T>
    T read() {
        T value{};
        if (const char* from = read_bytes(sizeof value)) std::memcpy(&value, from, sizeof value);
        return value;
    }
    template <PacketValue T>
    std::vector<T> read_all() {
        const std::size_t count = read_count(sizeof(T));
        std::vector<T> values(count);
        const char* from = read_bytes(count * sizeof(T));
        if (from != nullptr && count > 0)
            std::memcpy(static_cast<void*>(values.data()), from, count * sizeof(T));
        return values;
    }
    bool read_flag() { return read<std::uint8_t>() != 0; }
    std::string read_text() {
        const std::size_t count = read_count(1);
        const char* from = read_bytes(count);
        return from == nullptr ? std::string() : std::string(from, count);
    }
    /// Returns the number of items of at least `size` bytes that follow; 0 if so many are impossible.
    std::size_t read_count(std::size_t size) {
        const auto count = read<std::uint64_t>();
        if (count <= remaining_.size() / size) return static_cast<std::size_t>(count);
        is_complete_ = false;
        return 0;
    }

    bool is_complete() const { return is_complete_; }

  private:
    const char* read_bytes(std::size_t count) {
        if (!is_complete_ || count > remaining_.size()) {
            is_complete_ = false;
            return nullptr;
        }
        const char* from = remaining_.data();
        remaining_.remove_prefix(count);
        return from;
    }

    std::string_view remaining_;
    bool is_complete_ = true;
};

}  // namespace gsim::solid
