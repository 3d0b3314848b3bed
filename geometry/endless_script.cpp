// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/endless_script.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/errors.hpp"
#include "geometry/number_text.hpp"
#include "geometry/script_numbers.hpp"

namespace dmp::geometry {

namespace {

/// Of numbers in a list, and of rounds of a loop with those around it. gmsh takes about a second for a million.
constexpr double most = 1e7;

bool opens(const ScriptToken& token) { return token.is_symbol('(') || token.is_symbol('[') || token.is_symbol('{'); }
bool closes(const ScriptToken& token) { return token.is_symbol(')') || token.is_symbol(']') || token.is_symbol('}'); }

/// A pair of brackets that is open, and the item in it that is being read.
struct Bracket {
    std::size_t open = 0;
    double count = 0;               ///< of numbers that the ranges a : b : step in it stand for
    std::vector<std::size_t> ends;  ///< of the item: where its expressions begin and end, at symbols
    bool is_range = true;           ///< a ? b : c is none
};

/// Goes through a script once.
class Counts {
  public:
    Counts(const std::vector<ScriptToken>& tokens, const std::vector<std::string>& files)
        : tokens_(tokens), files_(files), numbers_(tokens) {}

    void check() {
        for (std::size_t i = 0; i < tokens_.size(); ++i) {
            const ScriptToken& token = tokens_[i];
            if (token.is_word("EndFor") && !loops_.empty()) loops_.pop_back();
            if (opens(token)) open_.push_back({i, 0, {i}});
            if (open_.empty()) continue;
            Bracket& inner = open_.back();
            if (token.is_symbol('?')) inner.is_range = false;
            if (token.is_symbol(':')) inner.ends.push_back(i);
            if (token.is_symbol(',') || closes(token)) {
                inner.ends.push_back(i);
                if (inner.is_range) inner.count += numbers_between(inner.ends);
                inner.ends = {i};
                inner.is_range = true;
            }
            if (!closes(token)) continue;
            check(inner);
            open_.pop_back();
        }
    }

  private:
    void check(const Bracket& whole) {
        if (begins_loop(whole.open)) {
            loops_.push_back(std::max(whole.count, 1.0) * (loops_.empty() ? 1 : loops_.back()));
            if (loops_.back() > most)
                refuse(whole.open,
                       "this loop takes " + number_text(loops_.back()) + " rounds, with the loops around it");
        } else if (whole.count > most) {
            refuse(whole.open, "this list is of " + number_text(whole.count) + " numbers");
        }
    }

    [[noreturn]] void refuse(std::size_t i, const std::string& problem) const {
        const ScriptToken& at = tokens_[i];
        throw InputError({.file = files_.at(static_cast<std::size_t>(at.file)), .line = at.line, .column = at.column},
                         problem + ", more than the " + number_text(most) + " that dmp lets gmsh begin",
                         "Correct its ends, or its step.");
    }

    /// For (a : b), For i In {a : b}.
    [[nodiscard]] bool begins_loop(std::size_t i) const {
        return (i >= 1 && tokens_[i - 1].is_word("For")) ||
               (i >= 3 && tokens_[i - 1].is_word("In") && tokens_[i - 3].is_word("For"));
    }

    [[nodiscard]] double numbers_between(const std::vector<std::size_t>& ends) const {
        if (ends.size() < 3 || ends.size() > 4) return 0;
        const auto part = [&](std::size_t k) { return numbers_.value(ends[k] + 1, ends[k + 1]); };
        const auto first = part(0), last = part(1), step = ends.size() == 4 ? part(2) : std::optional(1.0);
        if (!first || !last || !step || *step == 0) return 0;
        const double steps = ends.size() == 4 ? (*last - *first) / *step : std::abs(*last - *first);
        return std::isfinite(steps) && steps >= 0 ? std::floor(steps) + 1 : 0;
    }

    const std::vector<ScriptToken>& tokens_;
    const std::vector<std::string>& files_;
    ScriptNumbers numbers_;
    std::vector<Bracket> open_;
    std::vector<double> loops_;  ///< rounds of those that are open, with all around each
};

/// A call that is made whenever its macro is.
struct Call {
    std::string macro;
    std::size_t at;
};

/// By macro, what it always calls: outside of all conditions.
std::map<std::string, std::vector<Call>> calls_of_macros(const std::vector<ScriptToken>& tokens) {
    std::map<std::string, std::vector<Call>> calls;
    std::string macro;
    int conditions = 0;
    for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
        const ScriptToken& token = tokens[i];
        if (token.is_word("Macro") || token.is_word("Function")) {
            macro = tokens[i + 1].text;
            conditions = 0;
        }
        if (token.is_word("Return")) macro.clear();
        if (token.is_word("If")) ++conditions;
        if (token.is_word("EndIf")) --conditions;
        if (token.is_word("Call") && !macro.empty() && conditions == 0) calls[macro].push_back({tokens[i + 1].text, i});
    }
    return calls;
}

/// A call of a macro within itself, be it by way of others; none where there is none. Depth first, without recursion.
const Call* call_without_end(const std::map<std::string, std::vector<Call>>& calls) {
    struct Visit {
        const std::string* macro;
        const std::vector<Call>* calls;
        std::size_t next = 0;
    };
    std::set<std::string> begun, open;
    for (const auto& [first, own] : calls) {
        if (begun.contains(first)) continue;
        std::vector<Visit> path{{&first, &own}};
        begun.insert(first);
        open.insert(first);
        while (!path.empty()) {
            Visit& here = path.back();
            if (here.next == here.calls->size()) {
                open.erase(*here.macro);
                path.pop_back();
                continue;
            }
            const Call& call = (*here.calls)[here.next++];
            if (open.contains(call.macro)) return &call;
            const auto found = calls.find(call.macro);
            if (found == calls.end() || !begun.insert(call.macro).second) continue;
            open.insert(call.macro);
            path.push_back({&found->first, &found->second});
        }
    }
    return nullptr;
}

}  // namespace

void check_that_it_ends(const std::vector<ScriptToken>& tokens, const std::vector<std::string>& files) {
    Counts(tokens, files).check();
    const auto calls = calls_of_macros(tokens);
    if (const Call* const call = call_without_end(calls)) {
        const ScriptToken& at = tokens[call->at];
        throw InputError({.file = files.at(static_cast<std::size_t>(at.file)), .line = at.line, .column = at.column},
                         "the macro '" + call->macro + "' has no end: it calls itself each time",
                         "Call it within If ... EndIf, by a condition that comes to hold no more.");
    }
}

}  // namespace dmp::geometry
