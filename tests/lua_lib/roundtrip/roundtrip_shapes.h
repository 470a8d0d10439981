#pragma once

#include <array>
#include <string>
#include <vector>

#include "tests/lua_lib/roundtrip/roundtrip_model.h"
#include "tests/lua_lib/roundtrip/roundtrip_values.h"

namespace gsim::roundtrip {

/// Surroundings of a program part.
struct Scope {
    Names names;
    std::array<bool, 3> arcs{true, true, true};  ///< Planes in which an arc stays an arc.
    bool turned_systems = false;                 ///< RS274/NGC: systems are turned about Z.
};

/// Random blocks with a meaning of their own, wherever the program comes from: an arc names its plane and its
/// distance mode, an inverse time feed ends with the blocks that need it.
class Shapes {
  public:
    Shapes(Dialect dialect, Random& random) : dialect_(dialect), random_(random), values_(dialect, random) {}

    Block start();
    Body some(const Scope& scope);
    bool made_arcs() const { return made_arcs_; }
    void forget_arcs() { made_arcs_ = false; }
    Values& values() { return values_; }

    /// Polar programming (9/Series): lines between G16 and G15.
    Body polar(const Scope& scope);
    Body lines(const Scope& scope);
    Body cycle(const Scope& scope);

  private:
    bool is_ab9() const { return dialect_ == Dialect::ab9; }
    void add(Body& body, Block block) { body.push_back({.block = std::move(block)}); }
    void add_axes(Block& block, const Scope& scope, const std::string& letters);
    void add_modes_and_axes(Block& block, Scope scope, const std::string& letters);
    std::string some_of(const std::string& letters);
    Block line_block(const Scope& scope);
    Body arc(const Scope& scope);
    Block arc_block(const Scope& scope, int plane, bool absolute, const std::array<double, 2>& from,
                    const std::array<double, 2>& shift, ExprPtr scale);
    Body inverse_time(const Scope& scope);
    Body machine_coordinates(const Scope& scope);
    Body dwell(const Scope& scope);
    Body table(const Scope& scope);
    Body offset(const Scope& scope);
    Body tool(const Scope& scope);
    void add_cycle_words(Block& block, const Scope& scope, const std::string& code, int plane,
                         bool incremental, bool all);
    std::string cycle_code();

    Dialect dialect_;
    Random& random_;
    Values values_;
    bool made_arcs_ = false;
};

}  // namespace gsim::roundtrip
