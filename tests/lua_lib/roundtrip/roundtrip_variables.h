#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "tests/lua_lib/roundtrip/roundtrip_model.h"

namespace gsim::roundtrip {

/// A vacant variable of the 9/Series has no value.
using Value = std::optional<double>;

/// Variables and parameters, and the values of expressions, as the manuals of the two dialects have them.
class Variables {
  public:
    /// `system` returns the variables that the controller itself keeps (#5001, #5420, ..), and none for
    /// others.
    Variables(Dialect dialect, std::function<Value(int)> system)
        : dialect_(dialect), system_(std::move(system)) {}

    Value value(const Expr& expr);
    double number(const Expr& expr) { return value(expr).value_or(0); }
    bool is_true(const Expr& condition) { return number(condition) != 0; }
    void assign(const Expr& target, Value value);

    /// Around a call: local variables are new, and those of the caller come back.
    struct Locals {
        std::map<int, double> numbered;
        std::map<std::string, double> named;
    };
    Locals swap_locals(Locals locals);

    /// #<_value>
    void set_result(double value) { globals_["_value"] = value; }

    /// Returns true if a value lay so close to a jump of a function that the last bit of rounding decides the
    /// result.
    bool fragile() const { return fragile_; }

  private:
    bool is_local(int number) const { return number <= (dialect_ == Dialect::ab9 ? 33 : 30); }
    int index(const Expr& variable);
    Value read(int number);
    double function(const std::string& name, double x);
    double angle(double a, double b) const;
    double binary(const std::string& op, double a, double b);
    double comparison(const std::string& op, const Value& a, const Value& b);
    double logic(const std::string& op, double a, double b) const;
    double rounded(double x);
    double step(double x);
    const std::map<std::string, double>& scope(const std::string& name) const;

    Dialect dialect_;
    std::function<Value(int)> system_;
    Locals locals_;
    std::map<int, double> common_;
    std::map<std::string, double> globals_{{"_value", 0}};
    bool fragile_ = false;
};

}  // namespace gsim::roundtrip
