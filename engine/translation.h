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

/// The program to translate, and its options.
struct TranslationRequest {
    std::string program = {};       ///< A part program, by its name.
    std::optional<Text> text = {};  ///< The program, if it is not a file. Consumed by open().
    std::string machine = {};       ///< Dialect and units of its programs; empty: not specified.
    std::string machine_data = {};  ///< Aliases; empty: none.
    std::string cell = {};  ///< Names machine and machine data that are empty here; itself empty: none.
    LanguageOptions language = {};
    bool annotate = false;  ///< Each complete source block as a trailing comment.
    std::uint64_t max_errors = 100;
    double cpu_s = 86'400;  ///< Processor time of the calling thread, from open() on.
    Host host = {};
    Cancel cancel = {};
};

/// The translation of a part program to Lua: open(), make(), write().
class GSIM_API Translation {
  public:
    /// Reads the files that the request names in addition to the program, and opens the program.
    static tl::expected<Translation, Error> open(TranslationRequest request);
    Translation(Translation&&) noexcept;
    Translation& operator=(Translation&&) noexcept;
    ~Translation();

    /// Reserves the system resources of a long script now: a temporary file.
    void reserve_space();
    /// Translates. `on_diagnostic` receives the errors of the program; the returned error says that it has
    /// errors, or why it was not read to its end.
    tl::expected<void, Error> make(const DiagnosticHandler& on_diagnostic);
    /// Writes the Lua in parts: line n of the program is its line n+1. `callback` returns false to stop.
    tl::expected<void, Error> write(const std::function<bool(std::string_view)>& callback) const;

  private:
    class State;
    explicit Translation(std::unique_ptr<State> state);

    std::unique_ptr<State> state_;
};

/// Returns the reference of both dialects (docs/language.md).
GSIM_API std::string language_page();

}  // namespace gsim::engine
