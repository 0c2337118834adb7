// #while and #for: how they turn, how they end, and which of them never would.
#include <fmt/format.h>

#include <cmath>

#include "scene_reader/interpreter.h"

namespace rays::sdl {

void Interpreter::while_directive(Place opened) {
    if (blocks_.size() >= kMostOpenBlocks) too_deep();
    Block block;
    block.kind = Block::Kind::while_;
    block.opened = opened;
    block.again = scanner_.at();
    block.changes = changes_ - 1;
    if (is_endless(opened))
        fail(opened, "this loop never ends: its condition is a constant, and nothing in it is a #break");
    blocks_.push_back(block);
    turn_while(blocks_.size() - 1);
}

bool Interpreter::is_endless(Place opened) {
    const Place condition = scanner_.place();
    const bool is_constant = scanner_.next_is('(') && scanner_.scan(names_).is('(') && [this] {
        const Token token = scanner_.scan(names_);
        return (token.kind == Token::Kind::number && token.number != 0) || token.is(Word::true_) ||
               token.is(Word::yes_) || token.is(Word::on_);
    }() && scanner_.next_is(')');
    bool endless = false;
    if (is_constant) {
        const char* body = scanner_.at();
        skip_block(1, false, opened);
        endless = std::string_view(body, static_cast<std::size_t>(scanner_.at() - body)).find("break") ==
                  std::string_view::npos;
    }
    scanner_.move_to(condition.source, condition.at);
    return endless;
}

bool Interpreter::turn_while(std::size_t index) {
    scanner_.move_to(blocks_[index].opened.source, blocks_[index].again);
    if (blocks_[index].changes == changes_) {
        fail(blocks_[index].opened, "this loop never ends: a whole turn of it changed no variable");
    }
    blocks_[index].changes = changes_;
    if (std::abs(condition()) > kEpsilon) return true;
    skip_block(1, false, blocks_[index].opened);
    blocks_.pop_back();
    return false;
}

void Interpreter::for_directive(Place opened) {
    if (blocks_.size() >= kMostOpenBlocks) too_deep();
    const bool outer_hold = std::exchange(hold_, true);
    Block block;
    block.kind = Block::Kind::for_;
    block.opened = opened;
    expect('(', "#for");
    left_side_ = true;
    const Token variable = take();
    const std::shared_ptr<Value> slot = assignable(variable, true);
    left_side_ = false;
    hold_ = outer_hold;
    if (variable.array) fail(variable, "a loop's variable cannot be an array's element");
    block.variable = variable.name;
    comma();
    Numbers first;
    first.at[0] = number();
    comma();
    block.last = number();
    comma();
    block.step = number_or(1);
    if (!(std::abs(block.step) >= kEpsilon)) fail(opened, "the step of this loop is 0: it would never end");
    expect(')', "#for");
    slot->is = first;
    ++changes_;
    const bool runs = block.step > 0 ? first.at[0] < block.last + kEpsilon : first.at[0] > block.last - kEpsilon;
    if (!runs) {
        skip_block(1, false, opened);
        return;
    }
    block.again = scanner_.at();
    blocks_.push_back(block);
}

void Interpreter::end_directive(Place place) {
    if (blocks_.empty() || (!files_.empty() && blocks_.size() <= files_.back().blocks)) {
        fail(place, "#end without anything to end; remove it, or look for an #if or #while that is missing");
    }
    Block& block = blocks_.back();
    switch (block.kind) {
        case Block::Kind::if_:
        case Block::Kind::switch_: blocks_.pop_back(); return;
        case Block::Kind::macro: return return_from_macro();
        case Block::Kind::while_: turn_while(blocks_.size() - 1); return;
        case Block::Kind::for_: break;
    }
    auto& known = bindings(block.variable);
    Value* slot = known.empty() ? nullptr : known.back().slot.get();
    if (slot && slot->as<Reference>()) slot = slot->as<Reference>()->target.get();
    Numbers* variable = slot ? slot->as<Numbers>() : nullptr;
    if (!variable || variable->count != 1)
        fail(block.opened, "this loop's variable was undefined or is no float any more");
    variable->at[0] += block.step;
    ++changes_;
    const double now = variable->at[0];
    if (block.step > 0 ? now > block.last + kEpsilon : now < block.last - kEpsilon) {
        blocks_.pop_back();
    } else {
        scanner_.move_to(block.opened.source, block.again);
    }
}

void Interpreter::break_directive(Place place) {
    int levels = 1;
    while (!blocks_.empty() && blocks_.back().kind == Block::Kind::if_) {
        ++levels;
        blocks_.pop_back();
    }
    if (blocks_.empty() || (!files_.empty() && blocks_.size() <= files_.back().blocks)) {
        fail(place, "#break outside of a loop, a #switch or a macro");
    }
    if (blocks_.back().kind == Block::Kind::macro) return return_from_macro();
    skip_block(levels, false, place);
    blocks_.pop_back();
}

}  // namespace rays::sdl
