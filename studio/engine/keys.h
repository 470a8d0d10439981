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

/// A value in a message: a number as it is; of what may be of any length and depth the kind alone.
std::string shown(const nlohmann::json& value);

/// Takes the values of an object by their keys, each of one type. A key that is not there leaves its place
/// alone. The first fault is kept, and end() tells it: a sentence that names the key.
class Keys {
  public:
    /// `of`: whose keys these are, "data". `object` may be anything, and outlives this.
    Keys(const nlohmann::json& object, std::string of);

    void text(const char* key, std::string& place);
    /// A text that has to be there.
    void needed_text(const char* key, std::string& place);
    /// One of several words; the place gets its index.
    void word(const char* key, std::span<const char* const> words, std::optional<std::size_t>& place);
    /// A number from `least` to `most`.
    void number(const char* key, double least, double most, double& place);
    void number(const char* key, double least, double most, std::optional<double>& place);
    void whole(const char* key, int least, int most, std::optional<int>& place);
    void truth(const char* key, bool& place);
    void truth(const char* key, std::optional<bool>& place);
    void texts(const char* key, std::vector<std::string>& place);
    void numbers(const char* key, double least, double most, std::vector<double>& place);
    /// Three numbers, each from `least` to `most`.
    void point(const char* key, double least, double most, std::array<double, 3>& place);
    void point(const char* key, double least, double most, std::optional<std::array<double, 3>>& place);
    /// A list, or an object; null: it is not there.
    const nlohmann::json* list(const char* key);
    const nlohmann::json* object(const char* key);
    /// A value of any type; null: it is not there.
    const nlohmann::json* any(const char* key);
    /// That a key has to be there.
    void need(const char* key);
    /// Another fault.
    void fault(std::string sentence);

    /// The first fault of all, or a key that was not asked for.
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
