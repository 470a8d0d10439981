#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "base/text/json.h"

namespace gsim::studio {

/// Formats a value for a message: a number as it is; for values of any length and depth only their type.
std::string shown(const nlohmann::json& value);

/// Reader of the values of an object by their keys, each of one type. A missing key leaves its variable
/// unchanged. The first error is kept, and end() returns it: a message that names the key.
class Keys {
  public:
    /// `of`: owner of the keys, "data". `object` may be anything, and outlives this.
    Keys(const nlohmann::json& object, std::string of);

    void text(const char* key, std::string& place);
    /// Reads a required text.
    void needed_text(const char* key, std::string& place);
    /// Reads one of several words; `place` gets its index.
    void word(const char* key, std::span<const char* const> words, std::optional<std::size_t>& place);
    /// Reads a number from `least` to `most`.
    void number(const char* key, double least, double most, double& place);
    void number(const char* key, double least, double most, std::optional<double>& place);
    void whole(const char* key, int least, int most, std::optional<int>& place);
    void truth(const char* key, bool& place);
    void truth(const char* key, std::optional<bool>& place);
    void texts(const char* key, std::vector<std::string>& place);
    void numbers(const char* key, double least, double most, std::vector<double>& place);
    /// Reads three numbers, each from `least` to `most`.
    void point(const char* key, double least, double most, std::array<double, 3>& place);
    void point(const char* key, double least, double most, std::optional<std::array<double, 3>>& place);
    /// Returns a list, or an object; null: it is missing.
    const nlohmann::json* list(const char* key);
    const nlohmann::json* object(const char* key);
    /// Returns a value of any type; null: it is missing.
    const nlohmann::json* any(const char* key);
    /// Requires a key.
    void need(const char* key);
    /// Adds another error.
    void fault(std::string sentence);

    /// Returns the first error of all, or that of an unexpected key.
    tl::expected<void, std::string> end();

  private:
    const nlohmann::json* taken(const char* key, const char* wanted,
                                bool (nlohmann::json::*is)() const noexcept);
    bool all(const char* key, const nlohmann::json& list, const char* wanted,
             bool (nlohmann::json::*is)() const noexcept);
    void wrong(const char* key, const std::string& wanted, const nlohmann::json& value);

    const nlohmann::json& object_;
    std::string of_;
    std::vector<std::string> known_;
    std::optional<std::string> fault_;
};

}  // namespace gsim::studio
