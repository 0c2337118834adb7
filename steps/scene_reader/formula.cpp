#include "scene_reader/formula.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/error.h"
#include "scene_reader/token.h"

namespace rays::sdl {

namespace {

constexpr std::size_t kMostWaiting = 64;  ///< numbers on the stack
constexpr int kDeepest = 16;
constexpr std::int64_t kMostWork = 1'000'000'000'000'000;  ///< more than any reading has

bool is_true(double value) { return std::abs(value) > 1e-10; }

}  // namespace

// ---- Made from the text ---------------------------------------------------------------------------------------------

/// Interpreter's grammar of expressions (expressions.cpp), for floats alone. Throws NotAFormula for everything else.
class Formula::Maker {
public:
    struct NotAFormula {};

    Maker(const Function& function, Names& names) : function_(function), names_(names) {
        scanner_.move_to(function.source, function.body);
        next();
        sum();
        if (!token_.is('}') || token_.place.at != function.body_end) throw NotAFormula{};
        formula_.work_ += static_cast<std::int64_t>(formula_.operations_.size());
    }
    Formula take() { return std::move(formula_); }

private:
    /// As deep as a formula may be: the stack that waits is bounded, and this one with it.
    struct Nesting {
        explicit Nesting(int& depth) : depth_(depth) {
            if (++depth_ > 200) throw NotAFormula{};
        }
        ~Nesting() { --depth_; }
        int& depth_;
    };

    void next() { scanner_.scan(names_, token_); }
    bool accept(char symbol) {
        if (!token_.is(symbol)) return false;
        next();
        return true;
    }
    void expect(char symbol) {
        if (!accept(symbol)) throw NotAFormula{};
    }
    void add(Does does, int takes, std::uint32_t which = 0, double number = 0) {
        formula_.operations_.push_back({does, which, number});
        waiting_ += 1 - static_cast<std::size_t>(takes);
        if (waiting_ > kMostWaiting) throw NotAFormula{};
    }

    void expression() {
        const Nesting nesting(depth_);
        logical();
        if (!accept('?')) return;
        expression();
        expect(':');
        expression();
        add(Does::choose, 3);
    }
    void logical() {
        comparison();
        for (;;) {
            if (accept('&')) comparison(), add(Does::both, 2);
            else if (accept('|')) comparison(), add(Does::either, 2);
            else return;
        }
    }
    void comparison() {
        sum();
        for (;;) {
            const auto does = compares();
            if (!does) return;
            next();
            sum();
            add(*does, 2);
        }
    }
    std::optional<Does> compares() const {
        if (token_.kind != Token::Kind::symbol) return std::nullopt;
        switch (token_.symbol) {
            case '<': return Does::less;
            case '>': return Does::greater;
            case 'l': return Does::less_equal;
            case 'g': return Does::greater_equal;
            case '=': return Does::equal;
            case 'n': return Does::unequal;
            default: return std::nullopt;
        }
    }
    void sum() {
        product();
        for (;;) {
            if (accept('+')) product(), add(Does::add, 2);
            else if (accept('-')) product(), add(Does::subtract, 2);
            else return;
        }
    }
    void product() {
        factor();
        for (;;) {
            if (accept('*')) factor(), add(Does::multiply, 2);
            else if (accept('/')) factor(), add(Does::divide, 2);
            else return;
        }
    }
    void factor() {
        const Nesting nesting(depth_);
        while (accept('+')) {
        }
        if (accept('-')) factor(), add(Does::negate, 1);
        else if (accept('!')) factor(), add(Does::invert, 1);
        else primary();
        if (token_.is('.')) throw NotAFormula{};  // a component
    }
    void primary() {
        const Token token = token_;
        next();
        switch (token.kind) {
            case Token::Kind::number: return add(Does::number, 0, 0, token.number);
            case Token::Kind::symbol:
                if (token.symbol != '(') throw NotAFormula{};
                expression();
                return expect(')');
            case Token::Kind::word:
            case Token::Kind::name: break;
            default: throw NotAFormula{};
        }
        const auto& parameters = function_.parameters;
        const auto parameter = std::find(parameters.begin(), parameters.end(), token.name);
        if (parameter != parameters.end())
            add(Does::argument, 0, static_cast<std::uint32_t>(parameter - parameters.begin()));
        else if (token.kind == Token::Kind::word)
            word(token.word);
        else
            captured(token.name);
    }

    void captured(NameId name) {
        const auto& all = function_.captured;
        const auto found = std::find_if(all.begin(), all.end(), [&](const auto& c) { return c.first == name; });
        if (found == all.end()) throw NotAFormula{};
        const Value* value = found->second.get();
        while (const auto* reference = value->as<Reference>()) value = reference->target.get();
        if (const auto* numbers = value->as<Numbers>(); numbers && numbers->count == 1)
            return add(Does::number, 0, 0, numbers->at[0]);
        const auto called = value->shared<Function>();
        if (!called || !called->formula) throw NotAFormula{};
        call(*called);
    }
    void call(const Function& called) {
        const Formula& formula = *called.formula;
        formula_.depth_ = std::max(formula_.depth_, formula.depth_ + 1);
        if (formula_.depth_ > kDeepest) throw NotAFormula{};
        formula_.work_ = std::min(kMostWork, formula_.work_ + formula.work_);
        expect('(');
        for (std::size_t i = 0; i < called.parameters.size(); ++i) {
            if (i > 0) accept(',');
            sum();
        }
        expect(')');
        formula_.called_.push_back({called.formula, called.parameters.size()});
        add(Does::call, static_cast<int>(called.parameters.size()),
            static_cast<std::uint32_t>(formula_.called_.size() - 1));
    }

    void one(Does does) {
        expect('(');
        expression();
        expect(')');
        add(does, 1);
    }
    void two(Does does) {
        expect('(');
        sum();
        accept(',');
        sum();
        expect(')');
        add(does, 2);
    }
    void extreme(Does does) {
        expect('(');
        sum();
        while (accept(',')) sum(), add(does, 2);
        expect(')');
    }
    void word(Word word) {
        switch (word) {
            case Word::abs_: return one(Does::abs);
            case Word::acos_: return one(Does::acos);
            case Word::acosh_: return one(Does::acosh);
            case Word::asin_: return one(Does::asin);
            case Word::asinh_: return one(Does::asinh);
            case Word::atan_: return one(Does::atan);
            case Word::atan2_: return two(Does::atan2);
            case Word::atanh_: return one(Does::atanh);
            case Word::ceil_: return one(Does::ceil);
            case Word::cos_: return one(Does::cos);
            case Word::cosh_: return one(Does::cosh);
            case Word::degrees_: return one(Does::degrees);
            case Word::exp_: return one(Does::exp);
            case Word::floor_: return one(Does::floor);
            case Word::ln_: return one(Does::ln);
            case Word::log_: return one(Does::log);
            case Word::max_: return extreme(Does::max);
            case Word::min_: return extreme(Does::min);
            case Word::mod_: return two(Does::mod);
            case Word::pi_: return add(Does::number, 0, 0, std::numbers::pi);
            case Word::pow_: return two(Does::pow);
            case Word::radians_: return one(Does::radians);
            case Word::sin_: return one(Does::sin);
            case Word::sinh_: return one(Does::sinh);
            case Word::sqrt_: return one(Does::sqrt);
            case Word::tan_: return one(Does::tan);
            case Word::tanh_: return one(Does::tanh);
            default: throw NotAFormula{};
        }
    }

    const Function& function_;
    Names& names_;
    Scanner scanner_;
    Token token_;
    Formula formula_;
    std::size_t waiting_ = 0;
    int depth_ = 0;
};

std::shared_ptr<const Formula> formula_of(const Function& function, Names& names) {
    try {
        return std::make_shared<const Formula>(Formula::Maker(function, names).take());
    } catch (const Formula::Maker::NotAFormula&) {
        return nullptr;
    } catch (const InputError&) {  // the scanner's; who calls the function is told
        return nullptr;
    }
}

// ---- Evaluated ------------------------------------------------------------------------------------------------------

std::optional<double> Formula::of_one(Does does, double a) {
    constexpr double kDegree = std::numbers::pi / 180;
    switch (does) {
        case Does::abs: return std::abs(a);
        case Does::acos: return std::acos(std::clamp(a, -1.0, 1.0));
        case Does::acosh: return std::acosh(a);
        case Does::asin: return std::asin(std::clamp(a, -1.0, 1.0));
        case Does::asinh: return std::asinh(a);
        case Does::atan: return std::atan(a);
        case Does::atanh: return std::atanh(a);
        case Does::ceil: return std::ceil(a);
        case Does::cos: return std::cos(a);
        case Does::cosh: return std::cosh(a);
        case Does::degrees: return a / kDegree;
        case Does::exp: return std::exp(a);
        case Does::floor: return std::floor(a);
        case Does::ln: return a > 0 ? std::optional(std::log(a)) : std::nullopt;
        case Does::log: return a > 0 ? std::optional(std::log10(a)) : std::nullopt;
        case Does::radians: return a * kDegree;
        case Does::sin: return std::sin(a);
        case Does::sinh: return std::sinh(a);
        case Does::sqrt: return a < 0 ? std::nullopt : std::optional(std::sqrt(a));
        case Does::tan: return std::tan(a);
        default: return std::tanh(a);
    }
}

std::optional<double> Formula::of_two(Does does, double a, double b) {
    switch (does) {
        case Does::atan2:
            if (std::abs(a) <= 1e-10 && std::abs(b) <= 1e-10) return std::nullopt;
            return std::atan2(a, b);
        case Does::max: return std::max(a, b);
        case Does::min: return std::min(a, b);
        case Does::mod: return std::fmod(a, b);
        default:
            if (a == 0 && b == 0) return std::nullopt;
            return std::pow(a, b);
    }
}

std::optional<double> Formula::operator()(std::span<const double> arguments) const {
    std::array<double, kMostWaiting> stack;
    std::size_t size = 0;
    const auto pop = [&] { return stack[--size]; };
    const auto combine = [&](auto operation) {
        const double b = pop();
        stack[size - 1] = operation(stack[size - 1], b);
    };
    for (const Operation& o : operations_) {
        switch (o.does) {
            case Does::number: stack[size++] = o.number; break;
            case Does::argument: stack[size++] = arguments[o.which]; break;
            case Does::negate: stack[size - 1] = -stack[size - 1]; break;
            case Does::invert: stack[size - 1] = is_true(stack[size - 1]) ? 0 : 1; break;
            case Does::add: combine([](double a, double b) { return a + b; }); break;
            case Does::subtract: combine([](double a, double b) { return a - b; }); break;
            case Does::multiply: combine([](double a, double b) { return a * b; }); break;
            case Does::divide:
                if (stack[size - 1] == 0) return std::nullopt;
                combine([](double a, double b) { return a / b; });
                break;
            case Does::less: combine([](double a, double b) { return double(a < b); }); break;
            case Does::greater: combine([](double a, double b) { return double(a > b); }); break;
            case Does::less_equal:
                combine([](double a, double b) { return double(a <= b || !is_true(a - b)); });
                break;
            case Does::greater_equal:
                combine([](double a, double b) { return double(a >= b || !is_true(a - b)); });
                break;
            case Does::equal: combine([](double a, double b) { return double(!is_true(a - b)); }); break;
            case Does::unequal: combine([](double a, double b) { return double(is_true(a - b)); }); break;
            case Does::both: combine([](double a, double b) { return double(is_true(a) && is_true(b)); }); break;
            case Does::either: combine([](double a, double b) { return double(is_true(a) || is_true(b)); }); break;
            case Does::choose: {
                const double if_false = pop(), if_true = pop();
                stack[size - 1] = is_true(stack[size - 1]) ? if_true : if_false;
                break;
            }
            default: {
                std::optional<double> result;
                if (o.does == Does::call) {
                    const Called& called = called_[o.which];
                    size -= called.arguments;
                    for (std::size_t i = 0; i < called.arguments; ++i)
                        if (!std::isfinite(stack[size + i])) return std::nullopt;
                    result = (*called.formula)({&stack[size], called.arguments});
                } else if (o.does == Does::atan2 || o.does == Does::max || o.does == Does::min || o.does == Does::mod ||
                           o.does == Does::pow) {
                    const double b = pop(), a = pop();
                    if (!std::isfinite(a) || !std::isfinite(b)) return std::nullopt;
                    result = of_two(o.does, a, b);
                } else {
                    result = of_one(o.does, pop());
                }
                if (!result || !std::isfinite(*result)) return std::nullopt;
                stack[size++] = *result;
            }
        }
    }
    return std::isfinite(stack[0]) ? std::optional(stack[0]) : std::nullopt;
}

}  // namespace rays::sdl
