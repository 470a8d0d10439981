#include "tests/lua_lib/roundtrip/roundtrip_generator.h"

#include "tests/lua_lib/roundtrip/roundtrip_shapes.h"
#include "tests/lua_lib/roundtrip/roundtrip_transforms.h"

namespace gsim::roundtrip {

namespace {

constexpr int kSubs = 3;
constexpr int kMaxDepth = 3;

// Surroundings of a statement.
struct Surroundings : Scope {
    int depth = 0;          // of choices, loops and transformations
    int loops = 0;          // of loops
    bool may_jump = false;  // out of a loop that is open
    bool in_sub = false;
    std::size_t callable = 0;  // subs before this one
};

class Generator {
  public:
    Generator(Dialect dialect, unsigned seed) : random_(seed), shapes_(dialect, random_) {
        program_.dialect = dialect;
        turned_systems_ = !is_ab9() && random_.chance(2);
    }

    Program random_integer() {
        for (int i = 0; i < kSubs; ++i) add_sub();
        Surroundings current = environment();
        current.callable = program_.subs.size();
        current.names = is_ab9() ? ab9_names() : ngc_names();
        program_.main = named_parameters();
        program_.main.push_back({.block = shapes_.start()});
        append(program_.main, statements(current, random_.random_integer(15, 30)));
        return std::move(program_);
    }

  private:
    bool is_ab9() const { return program_.dialect == Dialect::ab9; }
    Values& values() { return shapes_.values(); }

    static void append(Body& body, Body more) {
        body.insert(body.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
    }

    static Statement assign(ExprPtr target, ExprPtr value) {
        return {.block = {.assignments = {{std::move(target), std::move(value)}}}};
    }

    Surroundings environment() const {
        Surroundings current;
        current.turned_systems = turned_systems_;
        return current;
    }

    // --- Names ---

    static void add_variables(std::vector<ExprPtr>& list, int first, int last) {
        for (int i = first; i <= last; ++i) list.push_back(variable(i));
    }

    // Positions and zero points to three digits: functions that jump are not to see the rounding of the
    // control.
    static void add_positions(Names& names, int first, int last) {
        for (int i = first; i <= last; ++i) {
            const ExprPtr thousandths = function("ROUND", binary(variable(i), "*", number("1000")));
            names.unbounded.push_back(binary(thousandths, "/", number("1000")));
        }
    }

    static Names ab9_names() {
        Names names;
        add_variables(names.writable, 1, 5);
        add_variables(names.writable, 100, 104);
        add_variables(names.writable, 500, 501);
        names.readable = names.writable;
        add_positions(names, 5001, 5003);
        add_positions(names, 5021, 5022);
        add_positions(names, 5221, 5221);
        return names;
    }

    static Names macro_names() {
        Names names;
        add_variables(names.writable, 100, 104);
        names.readable = names.writable;
        for (const int argument : {1, 2, 3, 4, 5, 6, 24, 25, 26})
            names.readable.push_back(variable(argument));
        add_positions(names, 5001, 5003);
        return names;
    }

    static Names ngc_names() {
        Names names;
        add_variables(names.writable, 1, 4);
        add_variables(names.writable, 31, 34);
        for (const char* name : {"a", "feed_2", "_g", "_h"}) names.writable.push_back(named(name));
        names.readable = names.writable;
        add_positions(names, 5420, 5422);
        names.optional = {"maybe", "_perhaps"};
        return names;
    }

    // Those that every expression may read have values from the start.
    Body named_parameters() {
        if (is_ab9()) return {};
        Body body;
        for (const char* name : {"a", "feed_2", "_g", "_h"})
            body.push_back(assign(named(name), values().constant(-9, 9)));
        return body;
    }

    // --- Subs ---

    void add_sub() {
        Surroundings current = environment();
        current.in_sub = true;
        current.callable = program_.subs.size();
        current.depth = 1;
        Sub sub;
        sub.kind = !is_ab9() ? CallKind::o_word : random_.chance(2) ? CallKind::macro : CallKind::m98;
        current.names = !is_ab9() ? ngc_names() : sub.kind == CallKind::macro ? macro_names() : ab9_names();
        shapes_.forget_arcs();
        if (!is_ab9())
            for (const char* name : {"a", "feed_2"})
                sub.body.push_back(assign(named(name), values().constant(-9, 9)));
        append(sub.body, statements(current, random_.random_integer(2, 4)));
        if (!is_ab9() && random_.chance(2)) sub.result = values().assigned(current.names);
        made_arcs_.push_back(shapes_.made_arcs());
        for (const std::size_t called : called_) made_arcs_.back() = made_arcs_.back() || made_arcs_[called];
        called_.clear();
        program_.subs.push_back(std::move(sub));
    }

    Body call(const Surroundings& current) {
        const bool all_arcs = current.arcs == environment().arcs;
        const auto index =
            static_cast<std::size_t>(random_.random_integer(0, static_cast<int>(current.callable) - 1));
        if (made_arcs_[index] && !all_arcs) return shapes_.some(current);
        called_.push_back(index);
        Statement call{.kind = StatementKind::call, .sub = index};
        const CallKind kind = program_.subs[index].kind;
        if (kind == CallKind::macro) {
            for (const char* letter : {"A", "B", "C", "I", "J", "K", "X", "Y", "Z"})
                if (random_.chance(3)) call.arguments.push_back({letter, values().coordinate(current.names)});
        } else if (kind == CallKind::o_word) {
            const int arguments = random_.random_integer(0, 4);
            for (int i = 0; i < arguments; ++i)
                call.arguments.push_back({"", values().coordinate(current.names)});
        }
        if (kind != CallKind::o_word && random_.chance(3)) call.count = values().constant(0, 2, 0);
        Body body;
        body.push_back(std::move(call));
        if (kind == CallKind::o_word && random_.chance(2))
            body.push_back(assign(random_.pick(current.names.writable), named("_value")));
        return body;
    }

    // --- Statements ---

    Body statements(const Surroundings& current, int count) {
        Body body;
        for (int i = 0; i < count; ++i) append(body, some(current));
        return body;
    }

    Body some(const Surroundings& current) {
        const bool shallow = current.depth < kMaxDepth;
        switch (random_.random_integer(0, 15)) {
            case 0:
            case 1:
            case 2: return assignments(current);
            case 3: return shallow ? choice(current) : assignments(current);
            case 4: return shallow && current.loops < 2 ? loop(current) : shapes_.some(current);
            case 5: return current.callable > 0 && current.loops < 2 ? call(current) : shapes_.some(current);
            case 6: return early_end(current);
            case 7: return is_ab9() ? shapes_.polar(current) : optional_parameter(current);
            case 8: return is_ab9() && shallow ? transformed(current) : shapes_.some(current);
            default: return shapes_.some(current);
        }
    }

    ExprPtr target(const Names& names) {
        if (names.counters.empty() || !random_.chance(3)) return random_.pick(names.writable);
        return variable(binary(random_.pick(names.counters), "+", number(is_ab9() ? "105" : "35")));
    }

    Body assignments(const Surroundings& current) {
        Statement statement;
        statement.block.assignments.push_back({target(current.names), values().assigned(current.names)});
        if (!is_ab9() && random_.chance(3))
            statement.block.assignments.push_back(
                {random_.pick(current.names.writable), values().assigned(current.names)});
        Body body;
        body.push_back(std::move(statement));
        // Two assignments to one parameter in one block would leave open which one is last.
        if (body[0].block.assignments.size() == 2) body[0].block.assignments[1].target = variable(6);
        return body;
    }

    Body optional_parameter(const Surroundings& current) {
        Body body;
        body.push_back({.kind = StatementKind::choice});
        body[0].branches.push_back({values().condition(current.names), {}});
        body[0].branches[0].body.push_back(
            assign(named(random_.pick(current.names.optional)), values().assigned(current.names)));
        return body;
    }

    Body choice(Surroundings current) {
        ++current.depth;
        Body body;
        body.push_back({.kind = StatementKind::choice});
        const int branches = random_.random_integer(1, 3);
        for (int i = 0; i < branches; ++i) {
            const bool otherwise = i > 0 && i == branches - 1;
            ExprPtr condition = otherwise ? ExprPtr() : values().condition(current.names);
            body[0].branches.push_back(
                {std::move(condition), statements(current, random_.random_integer(1, 3))});
        }
        return body;
    }

    // The counter is incremented first, so that a jump to the next pass cannot keep the loop running
    // endlessly.
    Body loop(Surroundings current) {
        ++current.depth;
        ++current.loops;
        current.may_jump = true;
        static constexpr StatementKind kKinds[] = {StatementKind::loop, StatementKind::do_loop,
                                                   StatementKind::repeat};
        Statement loop;
        loop.kind = kKinds[random_.random_integer(0, is_ab9() ? 1 : 2)];
        if (loop.kind == StatementKind::repeat) current.may_jump = false;
        const ExprPtr counter = variable(next_counter_++);
        Body body;
        body.push_back(assign(counter, number("0")));
        current.names.counters.push_back(counter);
        loop.count = values().constant(0, 4, 0);
        loop.condition = binary(counter, "LT", values().constant(1, 4, 0));
        if (random_.chance(4))
            loop.condition = binary(loop.condition, "AND", values().condition(current.names));
        loop.body.push_back(assign(counter, binary(counter, "+", number("1"))));
        append(loop.body, statements(current, random_.random_integer(1, 3)));
        body.push_back(std::move(loop));
        return body;
    }

    // Out of a loop or a sub, on a condition.
    Body early_end(const Surroundings& current) {
        Statement end;
        if (current.may_jump && (!current.in_sub || random_.chance(2))) {
            end.kind = random_.chance(2) ? StatementKind::leave : StatementKind::next;
        } else if (current.in_sub) {
            end.kind = StatementKind::give_back;
            if (!is_ab9() && random_.chance(2)) end.result = values().assigned(current.names);
        } else {
            return shapes_.lines(current);
        }
        Body body;
        body.push_back({.kind = StatementKind::choice});
        body[0].branches.push_back({values().condition(current.names), {}});
        body[0].branches[0].body.push_back(std::move(end));
        return body;
    }

    // Mirror image, scaling or rotation around some statements, which no jump leaves.
    Body transformed(Surroundings current) {
        ++current.depth;
        current.may_jump = false;
        current.in_sub = false;
        Bracket bracket = random_transformation(current, random_, values());
        Body body = std::move(bracket.begin);
        append(body, statements(current, random_.random_integer(1, 3)));
        body.push_back({.block = std::move(bracket.end)});
        return body;
    }

    Random random_;
    Shapes shapes_;
    Program program_;
    std::vector<bool> made_arcs_;      // by sub, what it calls included
    std::vector<std::size_t> called_;  // by the sub that is being made
    bool turned_systems_ = false;
    int next_counter_ = 120;
};

}  // namespace

Program random_program(Dialect dialect, unsigned seed) {
    return Generator(dialect, seed).random_integer();
}

}  // namespace gsim::roundtrip
