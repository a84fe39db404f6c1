// A recursive descent with one loop for all binary operators, which climbs by their precedence (Richards 1979). Names
// are looked up and kinds are checked while parsing, so that every error has its place in the text.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "scene/expressions/foreign_grammar.hpp"
#include "scene/expressions/name_lookup.hpp"
#include "scene/expressions/program.hpp"
#include "scene/expressions/token.hpp"
#include "scene/model/frame.hpp"

namespace tumble::scene {

namespace {

constexpr double kMaxExponent = 64.0;

struct Operator {
    std::string_view sign;
    int level;  // operators of a higher level bind first
    Op op;
    ValueKind takes;
};
constexpr int kOr = 1, kAnd = 2, kCompare = 3, kSum = 4, kProduct = 5, kSign = 6;
constexpr std::array<Operator, 12> kOperators{{
    {"or", kOr, Op::either, kCondition},
    {"and", kAnd, Op::both, kCondition},
    {"<", kCompare, Op::less, kNumber},
    {"<=", kCompare, Op::less_equal, kNumber},
    {">", kCompare, Op::greater, kNumber},
    {">=", kCompare, Op::greater_equal, kNumber},
    {"==", kCompare, Op::equal, kNumber},
    {"!=", kCompare, Op::not_equal, kNumber},
    {"+", kSum, Op::add, kNumber},
    {"-", kSum, Op::subtract, kNumber},
    {"*", kProduct, Op::multiply, kNumber},
    {"/", kProduct, Op::divide, kNumber},
}};

const Operator* find_operator(const Token& token) {
    for (const Operator& known : kOperators)
        if (token.is(known.sign)) return &known;
    return nullptr;
}

class Parser {
public:
    Parser(std::string_view text, const KnownNames* known)
        : text_(text), tokens_(read_tokens(text)), lookup_(known, program_) {
        program_.text = std::string(text);
    }

    Program parse() {
        program_.root = expression(kOr);
        if (now().kind != Token::Kind::end) unexpected("an operator or the end");
        return std::move(program_);
    }

private:
    const Token& now() const { return tokens_[at_]; }
    const Token& next() const { return tokens_[std::min(at_ + 1, tokens_.size() - 1)]; }
    Token take() { return now().kind == Token::Kind::end ? now() : tokens_[at_++]; }
    // The text of a node, in brackets if it is an operator, so that it may stand anywhere.
    std::string operand(const Node& node) const {
        const bool is_operator = node.op > Op::call;
        return is_operator ? "(" + source(node) + ")" : source(node);
    }
    std::string source(const Node& node) const { return std::string(text_.substr(node.begin, node.end - node.begin)); }
    // Of the token that was taken last, so that a part of the text that ends in a bracket has its bracket.
    std::size_t taken_end() const { return at_ == 0 ? 0 : tokens_[at_ - 1].end; }

    [[noreturn]] void unexpected(const std::string& wanted) const {
        const Token& token = now();
        const std::string got = token.kind == Token::Kind::end
                                    ? "the end"
                                    : "'" + std::string(text_.substr(token.begin, token.end - token.begin)) + "'";
        const std::string_view hint = token.kind == Token::Kind::sign ? own_word(token.text) : "";
        throw ExpressionError(token.begin, "expected " + wanted + ", got " + got, std::string(hint));
    }

    void expect(std::string_view sign) {
        if (!now().is(sign)) unexpected("'" + std::string(sign) + "'");
        take();
    }

    std::size_t add(Node node) {
        program_.nodes.push_back(std::move(node));
        return program_.nodes.size() - 1;
    }

    void require_kind(std::size_t index, ValueKind kind, const std::string& where) const {
        const Node& node = program_.nodes[index];
        if (node.kind == kind) return;
        const bool is_number = node.kind == kNumber;
        const std::string compared = source(node) + " > 0";
        const bool is_side = where == "'=='" || where == "'!='";  // of another comparison
        throw ExpressionError(node.begin,
                              where + " needs a " + (is_number ? "condition" : "number") + "; '" + source(node) +
                                  "' is a " + (is_number ? "number" : "condition"),
                              is_number ? "compare it: " + (is_side ? "(" + compared + ")" : compared)
                                        : "if(" + source(node) + ", 1, 0) is a number");
    }

    std::size_t expression(int least_level) {
        if (++depth_ > kMaxExpressionDepth)
            throw ExpressionError(
                now().begin, "the expression is nested deeper than " + std::to_string(kMaxExpressionDepth) + " levels");
        const std::size_t begin = now().begin;
        std::size_t left = prefix();
        std::size_t last_compared = 0, last_begin = 0;  // right side of the comparison before, in a < b < c
        bool is_chain = false;
        for (const Operator* found = find_operator(now()); found != nullptr && found->level >= least_level;
             found = find_operator(now())) {
            const Operator op = *found;
            take();
            const std::size_t right_begin = now().begin;
            const std::size_t right = expression(op.level + 1);
            if (op.level == kCompare && is_chain) {
                const std::size_t more = binary(op, last_compared, right, last_begin);
                left = binary(kOperators[1], left, more, begin);
            } else {
                left = binary(op, left, right, begin);
            }
            is_chain = op.level == kCompare;
            last_compared = right;
            last_begin = right_begin;
        }
        --depth_;
        return left;
    }

    // `begin` is where the text of the left side begins, with its brackets.
    std::size_t binary(const Operator& op, std::size_t left, std::size_t right, std::size_t begin) {
        const bool of_any_kind = op.op == Op::equal || op.op == Op::not_equal;
        const ValueKind takes = of_any_kind ? program_.nodes[left].kind : op.takes;
        const std::string where = "'" + std::string(op.sign) + "'";
        require_kind(left, takes, where);
        require_kind(right, takes, where);
        const bool is_condition = op.level <= kCompare;
        return add({.op = op.op,
                    .kind = is_condition ? kCondition : kNumber,
                    .operands = {left, right},
                    .begin = begin,
                    .end = taken_end()});
    }

    std::size_t prefix() {
        const std::size_t begin = now().begin;
        if (now().is("not")) {
            take();
            const std::size_t operand = expression(kCompare);
            require_kind(operand, kCondition, "'not'");
            return add(
                {.op = Op::negation, .kind = kCondition, .operands = {operand}, .begin = begin, .end = taken_end()});
        }
        if (now().is("-")) {
            take();
            const std::size_t operand = expression(kSign);
            require_kind(operand, kNumber, "'-'");
            return add({.op = Op::negate, .operands = {operand}, .begin = begin, .end = taken_end()});
        }
        return power();
    }

    std::size_t power() {
        const std::size_t begin = now().begin;
        const std::size_t base = primary();
        if (!now().is("^")) return base;
        require_kind(base, kNumber, "'^'");
        const std::string of_base = source(program_.nodes[base]);
        take();
        const bool is_negative = now().is("-");
        if (is_negative) take();
        const Token exponent = take();
        if (exponent.kind != Token::Kind::number || exponent.number != std::floor(exponent.number) ||
            exponent.number > kMaxExponent)
            throw ExpressionError(exponent.begin, "an exponent must be a whole number of at most 64",
                                  "sqrt(" + of_base + ") is the square root");
        return add({.op = Op::power,
                    .number = is_negative ? -exponent.number : exponent.number,
                    .operands = {base},
                    .begin = begin,
                    .end = exponent.end});
    }

    std::size_t primary() {
        const Token token = now();
        if (token.kind == Token::Kind::number) {
            take();
            return add({.number = token.number, .begin = token.begin, .end = token.end});
        }
        if (token.is("(")) {
            take();
            const std::size_t inner = expression(kOr);
            expect(")");
            return inner;
        }
        if (token.kind != Token::Kind::name || token.is("and") || token.is("or")) unexpected("a value");
        if (token.is("true") || token.is("false")) {
            take();
            return add(
                {.kind = kCondition, .number = token.is("true") ? 1.0 : 0.0, .begin = token.begin, .end = token.end});
        }
        if (!token.is_quoted && next().is("(")) return call();
        if (next().is(".")) return property();
        return world_value();
    }

    std::size_t world_value() {
        const Token token = take();
        if (const std::optional<std::size_t> given = lookup_.given_value(token))
            return add(
                {.op = Op::given_value, .code = static_cast<int>(*given), .begin = token.begin, .end = token.end});
        const Word<WorldValue>* word = token.is_quoted ? nullptr : find_word(world_words(), token.text);
        if (word == nullptr) lookup_.refuse_alone(token, is_touch_word(now().text) ? next().text : "");
        return add({.op = Op::world_value,
                    .kind = word->kind,
                    .code = static_cast<int>(word->code),
                    .begin = token.begin,
                    .end = token.end});
    }

    std::size_t property() {
        const Token name = take();
        take();
        const Token word = now();
        if (word.kind != Token::Kind::name) unexpected("a property after '.'");
        take();
        Node node = lookup_.property(name, word);
        node.begin = name.begin;
        node.end = word.end;
        return add(std::move(node));
    }

    std::size_t call() {
        const Token name = take();
        const FunctionWord* word = find_word(function_words(), name.text);
        if (word == nullptr)
            throw ExpressionError(name.begin, "there is no function '" + name.text + "'", own_function(name.text));
        take();
        Node node{.op = Op::call, .kind = word->kind, .code = static_cast<int>(word->code), .begin = name.begin};
        const bool may_be_about_copies = is_about_copies(word->code, 1);
        if (may_be_about_copies) lookup_.enter(name);
        std::size_t count = 0;
        do {
            if (count > 0) take();
            argument(*word, count++, node);
        } while (now().is(","));
        if (count < arguments_of(*word)) unexpected("',': " + std::string(word->form));
        node.end = now().end;
        expect(")");
        if (may_be_about_copies) leave(*word, count, node);
        return add(std::move(node));
    }

    static std::size_t arguments_of(const FunctionWord& word) {
        return word.takes.ends_with('+') ? 1 : word.takes.size();
    }

    void argument(const FunctionWord& word, std::size_t index, Node& node) {
        const bool repeats = word.takes.ends_with('+');
        if (index >= arguments_of(word) && !repeats)
            throw ExpressionError(now().begin, "too many arguments", std::string(word.form));
        const char wanted = word.takes[repeats ? 0 : index];
        if (wanted == 'b') {
            if (now().kind != Token::Kind::name) unexpected("the name of a body: " + std::string(word.form));
            node.names.push_back(lookup_.body(take()));
            return;
        }
        node.operands.push_back(expression(kOr));
        require_kind(node.operands.back(), wanted == 'c' ? kCondition : kNumber, "'" + std::string(word.name) + "'");
    }

    void leave(const FunctionWord& word, std::size_t arguments, Node& node) {
        const std::optional<NameLookup::Copies> copies = lookup_.leave();
        if (!is_about_copies(word.code, arguments)) {
            if (copies) refuse_copies(word, *copies, node);
            return;
        }
        if (copies) {
            node.names.push_back(copies->index);
            node.is_about_joints = copies->are_joints;
        }
        const bool may_lack_copies = lookup_.is_unchecked() || arguments != 1;
        if (copies || may_lack_copies) return;
        const Node& argument = program_.nodes[node.operands[0]];
        throw ExpressionError(
            node.begin, "'" + std::string(word.name) + "' needs the common name of copies",
            "a body or joint without a \"repeat\" has no copies: write " +
                (word.code == Function::count ? "if(" + source(argument) + ", 1, 0)" : operand(argument)) +
                " without the function");
    }

    // min and max with several arguments are of these, and not of copies. The hint has the argument that names them.
    [[noreturn]] void refuse_copies(const FunctionWord& word, const NameLookup::Copies& copies,
                                    const Node& node) const {
        const auto names_copies = [&](std::size_t operand) { return program_.nodes[operand].end > copies.begin; };
        const std::size_t argument = *std::ranges::find_if(node.operands, names_copies);
        throw ExpressionError(node.begin, "'" + lookup_.name_of(copies) + "' stands for several copies",
                              std::string(word.name) + "(" + source(program_.nodes[argument]) +
                                  ") with one argument is that of all copies");
    }

    std::string_view text_;
    std::vector<Token> tokens_;
    std::size_t at_ = 0;
    int depth_ = 0;
    Program program_;
    NameLookup lookup_;
};

// The names of given values must not hide words of the grammar.
void require_free(std::span<const std::string> values) {
    for (const std::string& name : values) {
        bool is_word = find_word(world_words(), name) != nullptr || find_operator({Token::Kind::name, 0, 0, name});
        for (const std::string_view word : {"true", "false", "not"}) is_word |= name == word;
        if (is_word) throw ExpressionError(0, "a value cannot be called '" + name + "', a word of conditions");
    }
}

}  // namespace

Program compile(std::string_view text, const KnownNames* known, const SceneFrame& frame) {
    if (text.size() > kMaxExpressionBytes)
        throw ExpressionError(kMaxExpressionBytes,
                              "an expression has at most " + std::to_string(kMaxExpressionBytes) + " bytes");
    if (known != nullptr) require_free(known->values);
    Program program = Parser(text, known).parse();
    program.frame = make_frame(frame);
    if (known != nullptr) program.first_spawned = known->bodies.built_count();
    return program;
}

Program compile_condition(std::string_view text, const KnownNames* known, const SceneFrame& frame) {
    Program program = compile(text, known, frame);
    if (program.kind() == kCondition) return program;
    throw ExpressionError(0, "must be a condition, and this is a number", "compare it: " + program.text + " > 0");
}

bool refers_to_names(std::string_view text) { return !compile(text, nullptr).spans.empty(); }

std::string with_prefix(std::string_view text, std::string_view prefix) {
    std::string result;
    std::size_t done = 0;
    for (const NameSpan& span : compile(text, nullptr).spans) {
        const std::string name = std::string(prefix) + span.name;
        result += text.substr(done, span.begin - done);
        result += in_expression(name);
        done = span.end;
    }
    return result + std::string(text.substr(done));
}

}  // namespace tumble::scene
