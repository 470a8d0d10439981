#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>

#include "lexer/diagnostics.h"

namespace gsim::codegen {

/// Programs and subroutines that a file defines, and the programs that it calls, which may be in other files.
class ProgramNames {
  public:
    /// Adds a program, by its name in Lua. Returns false if the file has it already.
    bool define(const std::string& lua_name) { return programs_.insert(lua_name).second; }
    /// Adds a subroutine, by its name in Lua. Returns the location of the first one of the name if the file
    /// has it already, or null.
    const lexer::Location* define_sub(const std::string& lua_name, const lexer::Location& location) {
        const auto [first, is_new] = subs_.try_emplace(lua_name, location);
        return is_new ? nullptr : &first->second;
    }
    /// Notes a call of a program by its number; of several calls the first one counts.
    void add_call(std::uint32_t number, const lexer::Location& location) {
        if (called_.size() < kMaxCalledPrograms) called_.try_emplace(number, location);
    }
    /// Reports calls of programs that the file does not define.
    void report_missing(lexer::Diagnostics& diagnostics) const;

  private:
    static constexpr std::size_t kMaxCalledPrograms = 10000;

    std::set<std::string> programs_;
    std::map<std::string, lexer::Location> subs_;
    std::map<std::uint32_t, lexer::Location> called_;
};

}  // namespace gsim::codegen
