// How a function's text becomes a formula.
#include <algorithm>
#include <numbers>
#include <optional>

#include "core/error.h"
#include "scene_reader/formula.h"
#include "scene_reader/token.h"

namespace rays::sdl {

namespace {

constexpr int kDeepest = 16;                               ///< calls inside of one another
constexpr std::int64_t kMostWork = 1'000'000'000'000'000;  ///< more than any reading has

}  // namespace

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
            if (accept('&'))
                comparison(), add(Does::both, 2);
            else if (accept('|'))
                comparison(), add(Does::either, 2);
            else
                return;
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
            if (accept('+'))
                product(), add(Does::add, 2);
            else if (accept('-'))
                product(), add(Does::subtract, 2);
            else
                return;
        }
    }
    void product() {
        factor();
        for (;;) {
            if (accept('*'))
                factor(), add(Does::multiply, 2);
            else if (accept('/'))
                factor(), add(Does::divide, 2);
            else
                return;
        }
    }
    void factor() {
        const Nesting nesting(depth_);
        while (accept('+')) {
        }
        if (accept('-'))
            factor(), add(Does::negate, 1);
        else if (accept('!'))
            factor(), add(Does::invert, 1);
        else
            primary();
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

    struct Named {
        Word word;
        Does does;
        enum Takes { one, two, many } takes;
    };
    static constexpr Named kFunctions[] = {
        {Word::abs_, Does::abs, Named::one},         {Word::acos_, Does::acos, Named::one},
        {Word::acosh_, Does::acosh, Named::one},     {Word::asin_, Does::asin, Named::one},
        {Word::asinh_, Does::asinh, Named::one},     {Word::atan_, Does::atan, Named::one},
        {Word::atan2_, Does::atan2, Named::two},     {Word::atanh_, Does::atanh, Named::one},
        {Word::ceil_, Does::ceil, Named::one},       {Word::cos_, Does::cos, Named::one},
        {Word::cosh_, Does::cosh, Named::one},       {Word::degrees_, Does::degrees, Named::one},
        {Word::exp_, Does::exp, Named::one},         {Word::floor_, Does::floor, Named::one},
        {Word::ln_, Does::ln, Named::one},           {Word::log_, Does::log, Named::one},
        {Word::max_, Does::max, Named::many},        {Word::min_, Does::min, Named::many},
        {Word::mod_, Does::mod, Named::two},         {Word::pow_, Does::pow, Named::two},
        {Word::radians_, Does::radians, Named::one}, {Word::sin_, Does::sin, Named::one},
        {Word::sinh_, Does::sinh, Named::one},       {Word::sqrt_, Does::sqrt, Named::one},
        {Word::tan_, Does::tan, Named::one},         {Word::tanh_, Does::tanh, Named::one}};

    void word(Word word) {
        if (word == Word::pi_) return add(Does::number, 0, 0, std::numbers::pi);
        const auto named = std::find_if(std::begin(kFunctions), std::end(kFunctions),
                                        [&](const Named& function) { return function.word == word; });
        if (named == std::end(kFunctions)) throw NotAFormula{};
        expect('(');
        if (named->takes == Named::one) {
            expression();
            add(named->does, 1);
        } else {
            sum();
            if (named->takes == Named::two) accept(','), sum(), add(named->does, 2);
            while (named->takes == Named::many && accept(',')) sum(), add(named->does, 2);
        }
        expect(')');
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

}  // namespace rays::sdl
