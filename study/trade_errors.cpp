// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "study/trade_errors.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace dmp::study {

namespace {

constexpr double lowest_order = 0.5, highest_order = 4, most_apart = 0.75;

/// A run's distance from the reference.
struct Distance {
    double spacing = 0, distance = 0;
};

/// d of the coarser over d of the finer where d = C (h^p - h0^p); it grows with p.
double ratio_at(double order, const Distance& coarse, const Distance& fine, double finest) {
    const double own = std::pow(finest, order);
    return (std::pow(coarse.spacing, order) - own) / (std::pow(fine.spacing, order) - own);
}

/// p through two distances, by bisection.
std::optional<double> order_through(const Distance& coarse, const Distance& fine, double finest) {
    if (!(fine.distance > 0) || !(coarse.distance > fine.distance)) return {};
    const double ratio = coarse.distance / fine.distance;
    double low = lowest_order, high = highest_order;
    if (ratio < ratio_at(low, coarse, fine, finest) || ratio > ratio_at(high, coarse, fine, finest)) return {};
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (ratio < ratio_at(middle, coarse, fine, finest) ? high : low) = middle;
    }
    return (low + high) / 2;
}

/// Of the reference, by the run next to twice its spacing, or else the coarsest one. `distances`: coarsest first.
double error_at_low_order(const std::vector<Distance>& distances, double finest) {
    const Distance* chosen = &distances.front();
    for (const Distance& each : distances)
        if (each.spacing > 1.8 * finest) chosen = &each;
    const auto error_at = [&](double order) {
        const double own = std::pow(finest, order);
        return chosen->distance * own / (std::pow(chosen->spacing, order) - own);
    };
    const Distance &coarse = distances.front(), &fine = distances.back();
    const bool is_slow = distances.size() > 1 && coarse.distance > fine.distance &&
                         coarse.distance < fine.distance * ratio_at(lowest_order, coarse, fine, finest);
    return error_at(is_slow ? lowest_order : 1);
}

class Errors {
  public:
    Errors(const TradeSettings& settings, const std::vector<TradeRun>& runs, const std::vector<TradeColumn>& columns)
        : settings_(settings), runs_(runs), columns_(columns) {}

    TradeErrors all() {
        TradeErrors errors;
        errors.reference = reference_ = given().value_or(*finest());
        errors.runs.resize(runs_.size());
        for (std::size_t c = 0; c < columns_.size(); ++c) {
            for (std::size_t r = 0; r < runs_.size(); ++r) errors.runs[r].distance.push_back(from_reference(r, c));
            errors.columns.push_back(trust_of(c, errors.runs));
        }
        for (RunError& each : errors.runs) add_largest(each, errors.columns);
        return errors;
    }

  private:
    [[nodiscard]] const TradeSetting& setting(std::size_t run) const { return settings_.settings[runs_[run].setting]; }
    [[nodiscard]] double rank_at(std::size_t run) const { return setting(run).level.rank; }
    [[nodiscard]] bool is_candidate(std::size_t run) const { return setting(run).role == TradeRole::candidate; }

    /// `series_of`: of the other one, by column.
    template <class SeriesOf>
    [[nodiscard]] SeriesError between(std::size_t run, const SeriesOf& series_of, std::size_t column) const {
        SeriesSize size;
        for (std::size_t c = 0; c < columns_.size(); ++c)
            if (columns_[c].vector == columns_[column].vector) size = size.with(size_of(series_of(c)));
        return error_of(runs_[run].measures[column], series_of(column), size);
    }
    [[nodiscard]] SeriesError between(std::size_t run, std::size_t other, std::size_t column) const {
        return between(
            run, [&](std::size_t c) -> const TimeSeries& { return runs_[other].measures[c]; }, column);
    }
    [[nodiscard]] SeriesError from_reference(std::size_t run, std::size_t column) const {
        if (!columns_[column].exact) return between(run, reference_, column);
        const auto exact = [&](std::size_t c) -> const TimeSeries& {
            return columns_[c].exact ? *columns_[c].exact : runs_[reference_].measures[c];
        };
        return between(run, exact, column);
    }

    [[nodiscard]] std::optional<std::size_t> given() const {
        for (std::size_t run = 0; run < runs_.size(); ++run)
            if (setting(run).role == TradeRole::reference) return run;
        return {};
    }

    /// The candidate with the smallest spacing, then of the highest level; none where there is no other than `but`.
    [[nodiscard]] std::optional<std::size_t> finest(std::optional<std::size_t> but = {}) const {
        std::optional<std::size_t> best;
        for (std::size_t run = 0; run < runs_.size(); ++run)
            if (is_candidate(run) && run != but && (!best || rank(run) < rank(*best))) best = run;
        return best;
    }
    /// Lower is finer.
    [[nodiscard]] std::pair<double, double> rank(std::size_t run) const {
        return {setting(run).spacing, -rank_at(run)};
    }

    [[nodiscard]] double scatter_of(std::size_t column) const {
        double scatter = no_number;
        for (std::size_t r = 0; r < runs_.size(); ++r) {
            if (setting(r).role != TradeRole::repeat) continue;
            for (std::size_t other = 0; other < runs_.size(); ++other) {
                const TradeSetting& repeated = setting(other);
                if (!is_candidate(other) || rank_at(other) != rank_at(r) ||
                    std::abs(repeated.spacing / setting(r).spacing - 1) > 0.01)
                    continue;
                scatter = std::fmax(scatter, between(r, other, column).largest());
            }
        }
        return scatter;
    }

    /// The level whose runs show the convergence: the reference's, or, where none of it has been run, the finest run's.
    [[nodiscard]] double level() const {
        const double own = rank_at(reference_);
        for (std::size_t run = 0; run < runs_.size(); ++run)
            if (is_candidate(run) && rank_at(run) == own) return own;
        return rank_at(*finest());
    }

    /// Of that level, coarsest first; those whose spacing is larger than that of the reference (`finest_spacing`).
    [[nodiscard]] std::vector<Distance> ladder(std::size_t column, const std::vector<RunError>& errors,
                                               double finest_spacing) const {
        std::vector<Distance> distances;
        for (std::size_t r = 0; r < runs_.size(); ++r) {
            const TradeSetting& each = setting(r);
            const double distance = errors[r].distance[column].largest();
            if (!is_candidate(r) || each.level.rank != level() || each.spacing <= finest_spacing * (1 + 1e-6) ||
                std::isnan(distance))
                continue;
            distances.push_back({each.spacing, distance});
        }
        std::ranges::sort(distances, std::greater(), &Distance::spacing);
        return distances;
    }

    /// Between the reference's level and the highest one, at the finest spacing that both have been run at; 0 where it
    /// is the highest, or no spacing is common.
    [[nodiscard]] double error_of_level(std::size_t column) const {
        const double own = rank_at(reference_);
        std::optional<std::pair<std::size_t, std::size_t>> best;
        for (std::size_t low = 0; low < runs_.size(); ++low)
            for (std::size_t high = 0; high < runs_.size(); ++high) {
                if (!is_candidate(low) || !is_candidate(high) || rank_at(low) != own || rank_at(high) <= own ||
                    setting(low).spacing != setting(high).spacing)
                    continue;
                if (!best || rank(high) < rank(best->second)) best = {low, high};
            }
        return best ? between(best->first, best->second, column).largest() : 0;
    }

    [[nodiscard]] ColumnTrust trust_of(std::size_t column, const std::vector<RunError>& errors) const {
        ColumnTrust trust;
        trust.is_exact = columns_[column].exact.has_value();
        const std::size_t finest_run = trust.is_exact ? *finest() : reference_;
        if (std::isnan(errors[finest_run].distance[column].largest())) {
            trust.has_size = false;
            trust.why_not = "zero, or without values, in the reference";
            return trust;
        }
        trust.scatter = scatter_of(column);
        const double spacing = trust.is_exact ? 0 : setting(reference_).spacing;
        const std::vector<Distance> distances = ladder(column, errors, spacing);
        add_order(trust, distances, spacing);
        if (trust.is_exact) {
            trust.reference = 0;
            return trust;
        }
        if (distances.empty()) {
            if (const auto next = finest(reference_)) trust.reference = errors[*next].distance[column].largest();
        } else if (std::isnan(trust.order)) {
            trust.reference = error_at_low_order(distances, spacing);
        } else {
            const double own = std::pow(spacing, trust.order), next = std::pow(distances.back().spacing, trust.order);
            trust.reference = distances.back().distance * own / (next - own);
        }
        trust.reference += error_of_level(column);
        return trust;
    }

    static void add_order(ColumnTrust& trust, const std::vector<Distance>& distances, double spacing) {
        if (distances.empty()) {
            trust.why_not = "no other spacing has been run at its level";
            return;
        }
        if (distances.size() < 3) {
            trust.why_not = "there are fewer than four spacings";
            return;
        }
        const auto last = distances.end();
        const auto coarse = order_through(*(last - 3), *(last - 2), spacing);
        const auto fine = order_through(*(last - 2), *(last - 1), spacing);
        if (!coarse || !fine)
            trust.why_not = fmt::format("it does not fall with an order of {} to {}", lowest_order, highest_order);
        else if (std::abs(*coarse - *fine) > most_apart)
            trust.why_not = fmt::format("two sets of spacings have the orders {:.1f} and {:.1f}", *coarse, *fine);
        else
            trust.order = *fine;
    }

    static void add_largest(RunError& run, const std::vector<ColumnTrust>& columns) {
        for (std::size_t c = 0; c < columns.size(); ++c) {
            if (!columns[c].counts()) continue;
            const double error = run.distance[c].largest() + columns[c].reference;
            if (std::isnan(error)) {
                run.error = no_number;
                run.column = c;
                return;
            }
            const double told = std::fmax(error, columns[c].scatter);
            if (told <= run.error) continue;
            run.error = told;
            run.column = c;
        }
    }

    const TradeSettings& settings_;
    const std::vector<TradeRun>& runs_;
    const std::vector<TradeColumn>& columns_;
    std::size_t reference_ = 0;
};

}  // namespace

TradeErrors trade_errors(const TradeSettings& settings, const std::vector<TradeRun>& runs,
                         const std::vector<TradeColumn>& columns) {
    return Errors(settings, runs, columns).all();
}

}  // namespace dmp::study
