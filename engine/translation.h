#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "engine/api.h"
#include "engine/diagnostic.h"
#include "engine/request.h"

namespace gsim::engine {

/// What is translated, and how.
struct TranslationRequest {
    std::string program = {};       ///< A part program, by its name.
    std::optional<Text> text = {};  ///< It, where it is no file. Taken by open().
    std::string machine = {};       ///< Dialect and units of its programs; empty: none is said.
    std::string machine_data = {};  ///< Aliases; empty: none.
    std::string cell = {};  ///< Names machine and machine data that are empty here; itself empty: none.
    LanguageChoice language = {};
    bool annotate = false;  ///< Each whole source block as a trailing comment.
    std::uint64_t max_errors = 100;
    double cpu_s = 86'400;  ///< Processor time of the calling thread, from open() on.
    Host host = {};
    Cancel cancel = {};
};

/// A part program on its way to Lua: open(), make(), write().
class GSIM_API Translation {
  public:
    /// Reads what the request names beside the program, and opens that.
    static tl::expected<Translation, Failure> open(TranslationRequest request);
    Translation(Translation&&) noexcept;
    Translation& operator=(Translation&&) noexcept;
    ~Translation();

    /// Takes now what a long script needs of the system: a temporary file.
    void reserve_space();
    /// Translates. `tell` gets what is wrong with the program; the failure says that it has errors, or why it
    /// was not read to its end.
    tl::expected<void, Failure> make(const Tell& tell);
    /// The Lua, in pieces: line n of the program is its line n+1. `take` returns false where it wants no
    /// more.
    tl::expected<void, Failure> write(const std::function<bool(std::string_view)>& take) const;

  private:
    class State;
    explicit Translation(std::unique_ptr<State> state);

    std::unique_ptr<State> state_;
};

/// The reference of both dialects (docs/language.md).
GSIM_API std::string language_page();

}  // namespace gsim::engine
