#include "tests/lua_lib/roundtrip/roundtrip_interpreter.h"

#include <cmath>

#include "tests/lua_lib/roundtrip/roundtrip_ab9.h"
#include "tests/lua_lib/roundtrip/roundtrip_ngc.h"

namespace gsim::roundtrip {

namespace {

// End of a body: at its end, or early.
enum class Ended { normally, leave, next, given_back, too_long };

// The local variables of a macro by the letters of its call.
const std::map<std::string, int> kMacroVariables{
    {"A", 1},  {"B", 2},  {"C", 3},  {"D", 7},  {"E", 8},  {"F", 9},  {"H", 11},
    {"I", 4},  {"J", 5},  {"K", 6},  {"M", 13}, {"Q", 17}, {"R", 18}, {"S", 19},
    {"T", 20}, {"U", 21}, {"V", 22}, {"W", 23}, {"X", 24}, {"Y", 25}, {"Z", 26}};

class Interpreter {
  public:
    Interpreter(const Program& program, Control& control)
        : program_(program),
          control_(control),
          variables_(program.dialect, [&control](int number) { return control.variable(number); }) {}

    Reading random_integer() {
        const Ended ended = run(program_.main);
        return {control_.moves(), variables_.fragile(), ended == Ended::too_long};
    }

  private:
    Ended run(const Body& body) {
        for (const Statement& statement : body)
            if (const Ended ended = run(statement); ended != Ended::normally) return ended;
        return Ended::normally;
    }

    Ended run(const Statement& s) {
        if (control_.moves().size() > kMaxMoves) return Ended::too_long;
        switch (s.kind) {
            case StatementKind::block: run(s.block); return Ended::normally;
            case StatementKind::choice: return choice(s);
            case StatementKind::loop:
            case StatementKind::do_loop:
            case StatementKind::repeat: return loop(s);
            case StatementKind::leave: return Ended::leave;
            case StatementKind::next: return Ended::next;
            case StatementKind::call: return call(s);
            case StatementKind::give_back: result_ = s.result; return Ended::given_back;
        }
        return Ended::normally;
    }

    // All values are those before the block.
    void run(const Block& block) {
        std::vector<Value> values;
        for (const Assignment& a : block.assignments) values.push_back(variables_.value(*a.value));
        ReadBlock read;
        read.codes.insert(block.codes.begin(), block.codes.end());
        for (const Word& word : block.words)
            if (const Value value = variables_.value(*word.value)) read.words[word.letter] = *value;
        for (std::size_t i = 0; i < values.size(); ++i)
            variables_.assign(*block.assignments[i].target, values[i]);
        control_.run(read);
    }

    Ended choice(const Statement& s) {
        for (const Branch& branch : s.branches)
            if (!branch.condition || variables_.is_true(*branch.condition)) return run(branch.body);
        return Ended::normally;
    }

    Ended loop(const Statement& s) {
        long passes = s.kind == StatementKind::repeat ? std::lround(variables_.number(*s.count)) : -1;
        const bool tests_before = s.kind == StatementKind::loop;
        while (passes != 0 && (!tests_before || variables_.is_true(*s.condition))) {
            const Ended ended = run(s.body);
            if (ended == Ended::leave) break;
            if (ended == Ended::given_back || ended == Ended::too_long) return ended;
            if (passes > 0) --passes;
            if (s.kind == StatementKind::do_loop && !variables_.is_true(*s.condition)) break;
        }
        return Ended::normally;
    }

    Ended call(const Statement& s) {
        const Sub& sub = program_.subs[s.sub];
        const long times = s.count ? std::lround(variables_.number(*s.count)) : 1;
        if (sub.kind == CallKind::m98) return passes(sub, times);
        Variables::Locals outer = variables_.swap_locals(arguments(s, sub.kind));
        const Ended ended = passes(sub, times);
        if (sub.kind == CallKind::o_word) variables_.set_result(result_ ? variables_.number(*result_) : 0);
        variables_.swap_locals(std::move(outer));
        return ended;
    }

    Ended passes(const Sub& sub, long times) {
        for (long pass = 0; pass < times; ++pass) {
            const Ended ended = run(sub.body);
            if (ended == Ended::too_long) return ended;
            if (ended == Ended::normally) result_ = sub.result;
        }
        return Ended::normally;
    }

    Variables::Locals arguments(const Statement& s, CallKind kind) {
        Variables::Locals locals;
        int number = 0;
        for (const Word& argument : s.arguments) {
            ++number;
            const int location = kind == CallKind::macro ? kMacroVariables.at(argument.letter) : number;
            if (const Value value = variables_.value(*argument.value)) locals.numbered[location] = *value;
        }
        return locals;
    }

    const Program& program_;
    Control& control_;
    Variables variables_;
    ExprPtr result_;  // with which the sub that runs will end
};

}  // namespace

Reading read(const Program& program, const std::array<Point, 9>& systems) {
    if (program.dialect == Dialect::ab9) {
        Ab9Control control(systems);
        return Interpreter(program, control).random_integer();
    }
    NgcControl control(systems);
    return Interpreter(program, control).random_integer();
}

}  // namespace gsim::roundtrip
