// Converts wishes to the options that make them.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <string>

#include "generator/options/option_table.hpp"

namespace hvi::gen {

namespace {

template <class Enumeration>
std::string option_for(const OptionEntry& option, Enumeration wished, Enumeration usual) {
    if (wished == usual) return "";
    const auto chosen =
        std::find_if(option.choices.begin(), option.choices.end(), [&](const Choice& choice) {
            return choice.value == static_cast<int>(wished);
        });
    HVI_CHECK(chosen != option.choices.end());
    return " " + std::string(option.name) + " " + std::string(chosen->name);
}

/// Returns the text of an option for each kind of member; empty where the wish is the usual one.
struct Quotation {
    const OptionEntry& option;
    const StepperWishes& wishes;
    const StepperWishes usual = {};

    [[nodiscard]] std::string name() const { return " " + std::string(option.name); }

    std::string operator()(std::monostate) const { return ""; }
    std::string operator()(bool StepperWishes::*member) const {
        return wishes.*member ? name() : "";
    }
    std::string operator()(Solver StepperWishes::*member) const {
        return option_for(option, wishes.*member, usual.*member);
    }
    std::string operator()(Wish<int> StepperWishes::*member) const {
        const int wished = (wishes.*member).choice;
        return wished == 0 ? "" : name() + " " + std::to_string(wished);
    }
    std::string operator()(Unroll StepperWishes::*member) const {
        return option_for(option, wishes.*member, usual.*member);
    }
    std::string operator()(Wish<Lanes> StepperWishes::*member) const {
        return option_for(option, (wishes.*member).choice, (usual.*member).choice);
    }
    std::string operator()(std::optional<Composition> StepperWishes::*member) const {
        return wishes.*member ? name() + " " + (wishes.*member)->name : "";
    }
    std::string operator()(Given StepperWishes::*member) const {
        return wishes.*member ? name() + " " + (wishes.*member)->text : "";
    }
};

}  // namespace

std::string options_for(const StepperWishes& wishes, Command command) {
    std::string text;
    for (const OptionEntry* option : options_of(command))
        text += std::visit(Quotation{*option, wishes}, option->wish);
    return text;
}

}  // namespace hvi::gen
