#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace gsim::solid {

/// Types for which any bytes are a value; a bool is 0 or 1 only (put_flag()).
template <typename T>
concept PacketValue = std::is_trivially_copyable_v<T> && !std::is_same_v<T, bool>;

/// Writer of consecutive values as bytes, between two programs of one build on one machine.
class PacketWriter {
  public:
    template <PacketValue T>
    void put(const T& value) {
        bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    template <PacketValue T>
    void put_all(const std::vector<T>& values) {
        put(static_cast<std::uint64_t>(values.size()));
        bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
    }
    void put_flag(bool flag) { put(static_cast<std::uint8_t>(flag ? 1 : 0)); }
    void put_text(std::string_view text) {
        put(static_cast<std::uint64_t>(text.size()));
        bytes_.append(text);
    }

    const std::string& bytes() const { return bytes_; }

  private:
    std::string bytes_;
};

/// Reader of the values in the same order. If the bytes do not suffice, values are 0 and empty, and
/// is_whole() is false.
class PacketReader {
  public:
    explicit PacketReader(std::string_view bytes) : rest_(bytes) {}

    template <PacketValue T>
    T get() {
        T value{};
        if (const char* from = take(sizeof value)) std::memcpy(&value, from, sizeof value);
        return value;
    }
    template <PacketValue T>
    std::vector<T> get_all() {
        const std::size_t count = get_count(sizeof(T));
        std::vector<T> values(count);
        const char* from = take(count * sizeof(T));
        if (from != nullptr && count > 0)
            std::memcpy(static_cast<void*>(values.data()), from, count * sizeof(T));
        return values;
    }
    bool get_flag() { return get<std::uint8_t>() != 0; }
    std::string get_text() {
        const std::size_t count = get_count(1);
        const char* from = take(count);
        return from == nullptr ? std::string() : std::string(from, count);
    }
    /// Returns the number of items of at least `size` bytes that follow; 0 if so many are impossible.
    std::size_t get_count(std::size_t size) {
        const auto count = get<std::uint64_t>();
        if (count <= rest_.size() / size) return static_cast<std::size_t>(count);
        whole_ = false;
        return 0;
    }

    bool is_whole() const { return whole_; }

  private:
    const char* take(std::size_t count) {
        if (!whole_ || count > rest_.size()) {
            whole_ = false;
            return nullptr;
        }
        const char* from = rest_.data();
        rest_.remove_prefix(count);
        return from;
    }

    std::string_view rest_;
    bool whole_ = true;
};

}  // namespace gsim::solid
