#include "tests/lua_lib/roundtrip/roundtrip_variables.h"

#include <cmath>
#include <numbers>

#include "tests/lua_lib/roundtrip/roundtrip_units.h"

namespace gsim::roundtrip {

namespace {

constexpr double kTolerance = 1e-9;
constexpr double kEqual = 1e-4;  // EQ and NE of RS274/NGC

}  // namespace

Value Variables::value(const Expr& e) {
    switch (e.kind) {
        case ExprKind::number: return std::stod(e.text);
        case ExprKind::variable: return read(index(e));
        case ExprKind::named: return scope(e.text).at(e.text);
        case ExprKind::exists: return scope(e.text).contains(e.text) ? 1 : 0;
        case ExprKind::negative: return -number(*e.a);
        case ExprKind::function: return function(e.text, number(*e.a));
        case ExprKind::angle: return angle(number(*e.a), number(*e.b));
        case ExprKind::binary: break;
    }
    const Value a = value(*e.a), b = value(*e.b);
    if (e.text.size() == 2 && e.text[0] >= 'A' && e.text != "OR") return comparison(e.text, a, b);
    return binary(e.text, a.value_or(0), b.value_or(0));
}

void Variables::assign(const Expr& target, Value value) {
    if (target.kind == ExprKind::named) {
        (target.text.front() == '_' ? globals_ : locals_.named)[target.text] = value.value_or(0);
        return;
    }
    const int number = index(target);
    std::map<int, double>& stored = is_local(number) ? locals_.numbered : common_;
    if (value) {
        stored[number] = *value;
    } else {
        stored.erase(number);
    }
}

Variables::Locals Variables::swap_locals(Locals locals) {
    std::swap(locals, locals_);
    return locals;
}

int Variables::index(const Expr& variable) {
    return static_cast<int>(std::lround(number(*variable.a)));
}

Value Variables::read(int number) {
    if (const Value own = system_(number)) return own;
    const std::map<int, double>& stored = is_local(number) ? locals_.numbered : common_;
    const auto found = stored.find(number);
    if (found != stored.end()) return found->second;
    return dialect_ == Dialect::ab9 ? Value() : Value(0);
}

const std::map<std::string, double>& Variables::scope(const std::string& name) const {
    return name.front() == '_' ? globals_ : locals_.named;
}

// Checks the argument of functions that jump at integers.
double Variables::step(double x) {
    const double off = std::abs(x - std::round(x));
    if (off != 0 && off < kTolerance * (1 + std::abs(x))) fragile_ = true;
    return x;
}

double Variables::rounded(double x) {
    step(x + 0.5);
    return x < 0 ? std::ceil(x - 0.5) : std::floor(x + 0.5);
}

double Variables::function(const std::string& name, double x) {
    if (name == "SIN") return std::sin(x * kRadPerDeg);
    if (name == "COS") return std::cos(x * kRadPerDeg);
    if (name == "TAN") return std::tan(x * kRadPerDeg);
    if (name == "ASIN") return std::asin(x) / kRadPerDeg;
    if (name == "ACOS") return std::acos(x) / kRadPerDeg;
    if (name == "ATAN") return std::atan(x) / kRadPerDeg;
    if (name == "SQRT") return std::sqrt(x);
    if (name == "ABS") return std::abs(x);
    if (name == "LN") return std::log(x);
    if (name == "EXP") return std::exp(x);
    if (name == "ROUND") return rounded(x);
    step(x);
    const bool up = name == "FUP";
    if (dialect_ == Dialect::ngc) return up ? std::ceil(x) : std::floor(x);
    return (x < 0) == up ? std::floor(x) : std::ceil(x);
}

double Variables::angle(double a, double b) const {
    const double degrees = std::atan2(a, b) / kRadPerDeg;
    return dialect_ == Dialect::ab9 && degrees < 0 ? degrees + 360 : degrees;
}

double Variables::comparison(const std::string& op, const Value& a, const Value& b) {
    const double x = a.value_or(0), y = b.value_or(0);
    const double apart = std::abs(x - y);
    if ((apart != 0 && apart < kTolerance) || std::abs(apart - kEqual) < kTolerance) fragile_ = true;
    if (op == "EQ" || op == "NE") {
        bool equal = a.has_value() == b.has_value() && x == y;
        if (dialect_ == Dialect::ngc) equal = apart <= kEqual;
        return equal == (op == "EQ") ? 1 : 0;
    }
    if (op == "GT") return x > y ? 1 : 0;
    if (op == "GE") return x >= y ? 1 : 0;
    if (op == "LT") return x < y ? 1 : 0;
    return x <= y ? 1 : 0;
}

double Variables::logic(const std::string& op, double a, double b) const {
    if (dialect_ == Dialect::ngc) {
        const bool x = a != 0, y = b != 0;
        return (op == "AND" ? x && y : op == "OR" ? x || y : x != y) ? 1 : 0;
    }
    const long x = std::lround(a), y = std::lround(b);
    return static_cast<double>(op == "AND" ? x & y : op == "OR" ? x | y : x ^ y);
}

double Variables::binary(const std::string& op, double a, double b) {
    if (op == "+") return a + b;
    if (op == "-") return a - b;
    if (op == "*") return a * b;
    if (op == "/") return a / b;
    if (op == "**") return std::pow(a, b);
    if (op == "MOD") {
        const double size = dialect_ == Dialect::ngc ? std::abs(b) : b;
        const double quotient = step(a / size);
        // The division rounds a non-integer to an integer: 15.1 MOD 3.02 leaves nearly 3.02.
        if (quotient == std::floor(quotient) && std::fmod(a, size) != 0) fragile_ = true;
        return a - size * std::floor(quotient);
    }
    return logic(op, a, b);
}

}  // namespace gsim::roundtrip
