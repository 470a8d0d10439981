#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/text/json.h"

namespace gsim::studio {

/// Formats a value for a message: a number as it is; for values of any length and depth only their type.
std::string display_text(const nlohmann::json& value);

/// Reader of the values of an object by their keys, each of one type. A missing key leaves its variable
/// unchanged. The first error is kept, and end() returns it: a message that names the key.
class KeyReader {
  public:
    /// `of`: owner of the keys, "data". `object` may be anything, and outlives this.
    KeyReader(const nlohmann::json& object, std::string of);

    void text(const char* key, std::string& target);
    /// Reads a required text.
    void required_text(const char* key, std::string& target);
    /// Reads one of several words; `target` gets its index.
    void word(const char* key, std::span<const char* const> words, std::optional<std::size_t>& target);
    /// Reads a number from `min` to `max`.
    void number(const char* key, double min, double max, double& target);
    void number(const char* key, double min, double max, std::optional<double>& target);
    void read_integer(const char* key, int min, int max, std::optional<int>& target);
    void boolean(const char* key, bool& target);
    void boolean(const char* key, std::optional<bool>& target);
    void texts(const char* key, std::vector<std::string>& target);
    void numbers(const char* key, double min, double max, std::vector<double>& target);
    /// Reads three numbers, each from `min` to `max`.
    void point(const char* key, double min, double max, std::array<double, 3>& target);
    void point(const char* key, double min, double max, std::optional<std::array<double, 3>>& target);
    /// Returns a list, or an object; null: it is missing.
    const nlohmann::json* list(const char* key);
    const nlohmann::json* object(const char* key);
    /// Returns a value of any type; null: it is missing.
    const nlohmann::json* any(const char* key);
    /// Requires a key.
    void require(const char* key);
    /// Adds another error.
    void add_error(std::string message);

    /// Returns the first error of all, or that of an unexpected key.
    Result<void> end();

  private:
    const nlohmann::json* value_of_type(const char* key, const char* expected_type,
                                        bool (nlohmann::json::*is)() const noexcept);
    bool check_elements(const char* key, const nlohmann::json& list, const char* expected_type,
                        bool (nlohmann::json::*is)() const noexcept);
    void report_invalid(const char* key, const std::string& expected_type, const nlohmann::json& value);

    const nlohmann::json& object_;
    std::string owner_;
    std::vector<std::string> known_keys_;
    std::optional<std::string> error_;
};

}  // namespace gsim::studio
