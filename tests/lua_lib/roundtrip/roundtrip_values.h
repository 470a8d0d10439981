#pragma once

#include <random>
#include <string>
#include <vector>

#include "tests/lua_lib/roundtrip/roundtrip_model.h"

namespace gsim::roundtrip {

/// Draws from a fixed seed.
class Random {
  public:
    explicit Random(unsigned seed) : engine_(seed) {}

    int random_integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }
    /// True once in `of` times.
    bool chance(int of) { return random_integer(1, of) == 1; }
    double real(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }
    template <class List>
    auto& pick(List& list) {
        return list[static_cast<std::size_t>(random_integer(0, static_cast<int>(std::size(list)) - 1))];
    }

  private:
    std::mt19937 engine_;
};

/// Names that an expression can read and write.
struct Names {
    std::vector<ExprPtr> readable = {};  ///< Size below some hundreds.
    std::vector<ExprPtr> writable = {};
    std::vector<ExprPtr> counters = {};      ///< Counters of outer loops, integers from 0 to 9.
    std::vector<ExprPtr> unbounded = {};     ///< Positions and zero points.
    std::vector<std::string> optional = {};  ///< Named parameters that may be there or not.
};

/// Random expressions with functions that have a value for any values of the variables.
class Values {
  public:
    Values(Dialect dialect, Random& random) : dialect_(dialect), random_(random) {}

    /// Returns a number with up to `decimals` digits after the point.
    ExprPtr constant(double low, double high, int decimals = 3);
    /// Any expression; it may be large.
    ExprPtr any(const Names& names, int depth);
    /// Between -100 and 100, unless a variable is larger. In the 9/Series it may be vacant.
    ExprPtr coordinate(const Names& names);
    /// As a coordinate, and never vacant.
    ExprPtr filled(const Names& names);
    /// From `low` to below `low + range`.
    ExprPtr positive(const Names& names, int low, int range);
    ExprPtr condition(const Names& names);
    /// Returns the value for a variable: its growth is slow.
    ExprPtr assigned(const Names& names);

  private:
    ExprPtr leaf(const Names& names);
    ExprPtr call(const Names& names, int depth);
    ExprPtr operation(const Names& names, int depth);
    ExprPtr comparison(const Names& names);
    ExprPtr wrapped(const Names& names, int depth);
    ExprPtr shifted(const Names& names, double max);

    Dialect dialect_;
    Random& random_;
};

}  // namespace gsim::roundtrip
