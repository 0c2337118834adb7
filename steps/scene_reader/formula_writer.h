// The operations of a formula, one after the other.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "scene_reader/formula.h"

namespace rays::sdl {

/// Computes what is constant at once, and what is equal once. What does not fit is no formula.
class Formula::Writer {
protected:
    Writer() { constant(0); }

    /// Places of components: constants from 0, numbers of the world from kNumber, operations from kOperation. The first
    /// constant is 0, and stands where there is no component.
    struct Operand {
        std::uint16_t at[5] = {};
        int count = 1;
    };
    static constexpr std::uint16_t kNumber = 0x4000, kOperation = 0x8000;

    void promote(Operand& operand, int count) {
        for (int i = operand.count; i < count; ++i) operand.at[i] = operand.count == 1 ? operand.at[0] : 0;
        operand.count = std::max(operand.count, count);
    }
    std::uint16_t constant(double value) {
        auto& all = formula_.constants_;
        const auto same = [value](double x) { return x == value && std::signbit(x) == std::signbit(value); };
        const auto found = std::find_if(all.begin(), all.end(), same);
        if (found != all.end()) return static_cast<std::uint16_t>(found - all.begin());
        if (all.size() == kMostNumbers) return is_formula_ = false, std::uint16_t{0};
        all.push_back(value);
        return static_cast<std::uint16_t>(all.size() - 1);
    }
    std::uint16_t new_number() {
        if (formula_.numbers_ == kMostNumbers) return is_formula_ = false, kNumber;
        return static_cast<std::uint16_t>(kNumber + formula_.numbers_++);
    }
    std::uint16_t add(Does does, std::uint16_t a, std::uint16_t b = 0, std::uint16_t c = 0) {
        const std::uint16_t operands[] = {a, b, c};
        const int count = operands_of(does);
        const auto is_constant = [](std::uint16_t place) { return place < kNumber; };
        if (count > 0 && does != Does::draw && std::all_of(operands, operands + count, is_constant)) {
            const auto at = [&](int i) { return i < count ? formula_.constants_[operands[i]] : 0; };
            const double value = Formula::constant(does, at(0), at(1), at(2));
            if (std::isfinite(value)) return constant(value);
        }
        if (does == Does::draw || does == Does::call || does >= Does::rotate) return push({does, a, b, c});
        const auto [known, is_new] = known_.try_emplace({does, a, b, c}, std::uint16_t{0});
        if (is_new) known->second = push({does, a, b, c});
        return known->second;
    }
    std::uint16_t push(const Operation& operation) {
        auto& all = formula_.operations_;
        if (all.size() == kMostOperations) return is_formula_ = false, kOperation;
        all.push_back(operation);
        return static_cast<std::uint16_t>(kOperation + all.size() - 1);
    }
    std::uint16_t listed(std::initializer_list<Operand> operands) {
        const std::size_t first = formula_.operands_.size();
        for (const Operand& o : operands) formula_.operands_.insert(formula_.operands_.end(), o.at, o.at + o.count);
        if (formula_.operands_.size() > kMostOperations) is_formula_ = false;
        return static_cast<std::uint16_t>(first);
    }

    Operand filled(std::uint16_t place, int count) const {
        Operand operand;
        std::fill(operand.at, operand.at + count, place);
        operand.count = count;
        return operand;
    }
    Operand literal(double value, int wanted) { return filled(constant(value), wanted); }

    std::uint16_t final_place(std::uint16_t place) const {
        const std::size_t constants = formula_.constants_.size();
        if (place >= kOperation)
            return static_cast<std::uint16_t>(constants + formula_.numbers_ + (place - kOperation));
        return static_cast<std::uint16_t>(place >= kNumber ? constants + (place - kNumber) : place);
    }
    std::optional<Formula> finish(const Operand& value) {
        if (!is_formula_) return std::nullopt;
        static_assert(2 * kMostNumbers + kMostOperations <= kMostPlaces - 2);
        for (Operation& o : formula_.operations_) {
            const int count = operands_of(o.does);
            if (count > 0) o.a = final_place(o.a);
            if (count > 1 || o.does == Does::element) o.b = final_place(o.b);
            if (count > 2) o.c = final_place(o.c);
        }
        for (std::uint16_t& place : formula_.operands_) place = final_place(place);
        std::transform(value.at, value.at + 5, formula_.results_, [this](auto place) { return final_place(place); });
        formula_.count_ = value.count;
        for (const auto& kept : formula_.kept_) formula_.functions_.push_back(kept.get());
        const auto is_slow = [](const Operation& o) {
            return o.does >= Does::call || (o.does >= Does::abs && o.does < Does::add) ||
                   (o.does >= Does::atan2 && o.does < Does::choose);
        };
        const auto& all = formula_.operations_;
        formula_.work_ += 1 + static_cast<std::int64_t>(all.size()) / kOperationsPerToken +
                          std::count_if(all.begin(), all.end(), is_slow);
        return std::move(formula_);
    }

    Formula formula_;
    bool is_formula_ = true;

private:
    static constexpr std::size_t kMostOperations = 400;
    static constexpr int kOperationsPerToken = 8;  ///< done in the time in which a token is read

    std::map<std::tuple<Does, std::uint16_t, std::uint16_t, std::uint16_t>, std::uint16_t> known_;
};

}  // namespace rays::sdl
