#include "tests/lua_lib/roundtrip/roundtrip_text.h"

#include <algorithm>
#include <random>

#include <fmt/format.h>

namespace gsim::roundtrip {

namespace {

constexpr int kComparison = 2;
constexpr int kPrimary = 6;

// Returns how tightly an operator binds (docs/language.md).
int binding(const std::string& op, Dialect dialect) {
    const auto is_one_of = [&op](std::initializer_list<const char*> names) {
        return std::find(names.begin(), names.end(), op) != names.end();
    };
    if (op == "**") return 5;
    if (is_one_of({"*", "/", "MOD"})) return 4;
    if (is_one_of({"+", "-"})) return 3;
    if (dialect == Dialect::ab9 && op == "AND") return 4;
    if (dialect == Dialect::ab9 && is_one_of({"OR", "XOR"})) return 3;
    if (is_one_of({"AND", "OR", "XOR"})) return 1;
    return kComparison;
}

class ExprWriter {
  public:
    explicit ExprWriter(Dialect dialect) : dialect_(dialect) {}

    // Returns an operand that must bind at least so tightly.
    std::string operand(const Expr& e, int min) const {
        if (e.kind != ExprKind::binary) return primary(e);
        const std::string inner = joined(e);
        return binding(e.text, dialect_) >= min ? inner : "[" + inner + "]";
    }

    std::string primary(const Expr& e) const { return operand_of(e); }

    // Between brackets.
    std::string bracketed(const Expr& e) const { return "[" + operand(e, 0) + "]"; }

  private:
    std::string joined(const Expr& e) const {
        const int own = binding(e.text, dialect_);
        const bool is_word = e.text.front() >= 'A';
        const bool chains = own != kComparison || dialect_ == Dialect::ngc;
        return operand(*e.a, chains ? own : own + 1) + (is_word ? " " + e.text + " " : e.text) +
               operand(*e.b, own + 1);
    }

    std::string operand_of(const Expr& e) const {
        switch (e.kind) {
            case ExprKind::number: return e.text;
            case ExprKind::variable:
                return "#" + (e.a->kind == ExprKind::number ? e.a->text : operand(*e.a, kPrimary));
            case ExprKind::named: return "#<" + e.text + ">";
            case ExprKind::exists: return "EXISTS[#<" + e.text + ">]";
            case ExprKind::negative: return "-" + negated(*e.a);
            // ATAN[1]/[2] would be the angle of a point.
            case ExprKind::function:
                return e.text == "ATAN" ? "[ATAN" + bracketed(*e.a) + "]" : e.text + bracketed(*e.a);
            case ExprKind::angle: return "ATAN" + bracketed(*e.a) + "/" + bracketed(*e.b);
            case ExprKind::binary: break;
        }
        return bracketed(e);
    }

    std::string negated(const Expr& e) const {
        const std::string text = operand(e, kPrimary);
        return text.front() == '-' ? "[" + text + "]" : text;
    }

    Dialect dialect_;
};

class Writer {
  public:
    Writer(const Program& program, unsigned seed)
        : program_(program), expr_(program.dialect), random_(seed) {}

    std::string random_integer() {
        if (program_.dialect == Dialect::ab9) return whole_ab9();
        for (std::size_t i = 0; i < program_.subs.size(); ++i) o_sub(i);
        body(program_.main);
        line("M2");
        return text_;
    }

  private:
    // Labels at which a loop is left and its next pass begins, in the 9/Series with GOTO.
    struct OpenLoop {
        int leave = 0, next = 0;
    };

    bool is_ab9() const { return program_.dialect == Dialect::ab9; }
    bool chance(int of) { return std::uniform_int_distribution<int>(1, of)(random_) == 1; }

    void line(const std::string& content) { text_ += content + '\n'; }

    std::string whole_ab9() {
        line("O1");
        body(program_.main);
        line("M30");
        for (std::size_t i = 0; i < program_.subs.size(); ++i) {
            line(fmt::format("O{:04}", sub_number(i)));
            body(program_.subs[i].body);
            line("M99");
        }
        return text_;
    }

    void o_sub(std::size_t index) {
        const Sub& sub = program_.subs[index];
        current_sub_ = sub_label(index);
        line(fmt::format("o{} sub", current_sub_));
        body(sub.body);
        line(fmt::format("o{} endsub{}", current_sub_, result(sub.result)));
    }

    // Every other one has a name.
    static std::string sub_label(std::size_t index) {
        const int number = sub_number(index);
        return index % 2 == 1 ? fmt::format("<part_{}>", number) : std::to_string(number);
    }

    std::string result(const ExprPtr& expr) const { return expr ? " " + expr_.bracketed(*expr) : ""; }

    void body(const Body& statements) {
        for (const Statement& statement : statements) write(statement);
    }

    void write(const Statement& s) {
        switch (s.kind) {
            case StatementKind::block: return block(s.block);
            case StatementKind::choice: return is_ab9() ? choice_ab9(s) : choice_ngc(s);
            case StatementKind::loop:
            case StatementKind::do_loop:
            case StatementKind::repeat: return is_ab9() ? loop_ab9(s) : loop_ngc(s);
            case StatementKind::leave: return jump("break", loops_.back().leave);
            case StatementKind::next: return jump("continue", loops_.back().next);
            case StatementKind::call: return call(s);
            case StatementKind::give_back:
                return line(is_ab9() ? "M99" : fmt::format("o{} return{}", current_sub_, result(s.result)));
        }
    }

    // --- Blocks ---

    std::string value(const Expr& e) const {
        const bool plain = e.kind != ExprKind::binary;
        return plain ? expr_.primary(e) : expr_.bracketed(e);
    }

    std::string assignment(const Assignment& a) {
        const bool bare = is_ab9() && !chance(3);
        return expr_.primary(*a.target) + "=" + (bare ? expr_.operand(*a.value, 0) : value(*a.value));
    }

    void block(const Block& b) {
        std::vector<std::string> parts = b.codes;
        for (const Word& word : b.words) parts.push_back(word.letter + value(*word.value));
        for (const Assignment& a : b.assignments) parts.push_back(assignment(a));
        std::shuffle(parts.begin(), parts.end(), random_);
        const bool blanks = chance(2);
        std::string content;
        for (const std::string& part : parts) content += (blanks && !content.empty() ? " " : "") + part;
        line(content);
    }

    std::string words(const std::vector<Word>& all) const {
        std::string content;
        for (const Word& word : all) content += " " + word.letter + value(*word.value);
        return content;
    }

    void call(const Statement& s) {
        const int number = sub_number(s.sub);
        if (program_.subs[s.sub].kind == CallKind::o_word) {
            std::string arguments;
            for (const Word& argument : s.arguments) arguments += " " + expr_.bracketed(*argument.value);
            return line(fmt::format("o{} call{}", sub_label(s.sub), arguments));
        }
        const bool macro = program_.subs[s.sub].kind == CallKind::macro;
        line(fmt::format("{} P{}{}{}", macro ? "G65" : "M98", number, s.count ? " L" + value(*s.count) : "",
                         words(s.arguments)));
    }

    // --- The 9/Series: WHILE, IF THEN and GOTO ---

    int new_label() { return next_label_ += 5; }
    void jump(const char* o_word, int to) {
        line(is_ab9() ? fmt::format("GOTO{}", to) : fmt::format("o{} {}", to, o_word));
    }
    void location(int label) { line(fmt::format("N{}", label)); }

    static bool is_single_assignment(const Body& body) {
        return body.size() == 1 && body[0].kind == StatementKind::block && body[0].block.codes.empty() &&
               body[0].block.words.empty() && body[0].block.assignments.size() == 1;
    }

    void choice_ab9(const Statement& s) {
        if (s.branches.size() == 1 && is_single_assignment(s.branches[0].body)) {
            const Branch& only = s.branches[0];
            return line(fmt::format("IF{}THEN {}", expr_.bracketed(*only.condition),
                                    assignment(only.body[0].block.assignments[0])));
        }
        std::vector<int> labels;
        const int end = new_label();
        const Body* otherwise = nullptr;
        for (const Branch& branch : s.branches) {
            labels.push_back(new_label());
            if (!branch.condition) {
                otherwise = &branch.body;
            } else {
                line(fmt::format("IF{}GOTO{}", expr_.bracketed(*branch.condition), labels.back()));
            }
        }
        if (otherwise != nullptr) body(*otherwise);
        jump("", end);
        for (std::size_t i = 0; i < s.branches.size(); ++i) {
            if (!s.branches[i].condition) continue;
            location(labels[i]);
            body(s.branches[i].body);
            jump("", end);
        }
        location(end);
    }

    void loop_ab9(const Statement& s) {
        const OpenLoop loop{new_label(), new_label()};
        loops_.push_back(loop);
        if (s.kind == StatementKind::do_loop) {
            const int start = new_label();
            location(start);
            body(s.body);
            location(loop.next);
            line(fmt::format("IF{}GOTO{}", expr_.bracketed(*s.condition), start));
        } else {
            const int nesting = ++while_depth_;
            line(fmt::format("WHILE{}DO{}", expr_.bracketed(*s.condition), nesting));
            body(s.body);
            location(loop.next);
            line(fmt::format("END{}", nesting));
            --while_depth_;
        }
        location(loop.leave);
        loops_.pop_back();
    }

    // --- RS274/NGC: O-words ---

    void choice_ngc(const Statement& s) {
        const int id = new_label();
        for (std::size_t i = 0; i < s.branches.size(); ++i) {
            const Branch& branch = s.branches[i];
            const char* const word = i == 0 ? "if" : branch.condition ? "elseif" : "else";
            line(fmt::format("o{} {}{}", id, word, result(branch.condition)));
            body(branch.body);
        }
        line(fmt::format("o{} endif", id));
    }

    void loop_ngc(const Statement& s) {
        const int id = new_label();
        loops_.push_back({id, id});
        const bool is_do = s.kind == StatementKind::do_loop, repeats = s.kind == StatementKind::repeat;
        const std::string condition = result(repeats ? s.count : s.condition);
        line(fmt::format("o{} {}", id, is_do ? "do" : (repeats ? "repeat" : "while") + condition));
        body(s.body);
        line(fmt::format("o{} {}", id, is_do ? "while" + condition : repeats ? "endrepeat" : "endwhile"));
        loops_.pop_back();
    }

    const Program& program_;
    ExprWriter expr_;
    std::mt19937 random_;
    std::string text_;
    std::vector<OpenLoop> loops_;
    int next_label_ = 1000;
    int while_depth_ = 0;
    std::string current_sub_;
};

}  // namespace

std::string program_text(const Program& program, unsigned seed) {
    return Writer(program, seed).random_integer();
}

}  // namespace gsim::roundtrip
