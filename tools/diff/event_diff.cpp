#include "tools/diff/event_diff.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string_view>
#include <tuple>
#include <vector>

#include "tools/output/csv_file.hpp"
#include "tools/output/json_writer.hpp"
#include "tools/output/number_text.hpp"

namespace tumble::tools {

namespace {

constexpr std::array<std::string_view, 5> kNumbers{"x", "y", "nx", "ny", "speed"};

struct Event {
    std::uint64_t step = 0;
    double time = 0.0;
    std::array<std::string, 3> kind_and_names;         // event, a, b
    std::array<std::string, kNumbers.size()> numbers;  // texts, empty for events without a point
};

class EventFile {
public:
    explicit EventFile(const std::filesystem::path& file)
        : csv_(file, "step", "time", "event", "a", "b", "x", "y", "nx", "ny", "speed") {
        read();
    }

    const std::optional<Event>& next() const { return next_; }

    // The events of the step, in the order of the file; none if the next event belongs to a later step.
    std::vector<Event> take(std::uint64_t step) {
        std::vector<Event> events;
        for (; next_ && next_->step == step; read()) events.push_back(*next_);
        return events;
    }

private:
    void read() {
        std::array<char*, 10> fields{};
        next_.reset();
        if (!csv_.read(fields)) return;
        next_.emplace();
        next_->step = csv_.number<std::uint64_t>(fields[0]);
        next_->time = csv_.number<double>(fields[1]);
        std::copy_n(fields.begin() + 2, next_->kind_and_names.size(), next_->kind_and_names.begin());
        std::copy_n(fields.begin() + 5, next_->numbers.size(), next_->numbers.begin());
    }

    CsvFile<10> csv_;
    std::optional<Event> next_;
};

bool are_near(const std::string& a, const std::string& b, double tolerance) {
    if (a == b) return true;
    const std::optional<double> x = number_of(a), y = number_of(b);
    return x && y && std::abs(*x - *y) <= tolerance;
}

EventDifference difference_at(const Event& event) {
    EventDifference difference;
    difference.step = event.step;
    difference.time = event.time;
    difference.event = event.kind_and_names[0];
    difference.a = event.kind_and_names[1];
    difference.b = event.kind_and_names[2];
    return difference;
}

// The first number of two events that differs.
std::optional<EventDifference> compare_numbers(const Event& a, const Event& b, double tolerance) {
    for (std::size_t i = 0; i < kNumbers.size(); ++i) {
        if (are_near(a.numbers[i], b.numbers[i], tolerance)) continue;
        EventDifference difference = difference_at(a);
        difference.component = kNumbers[i];
        difference.in_a = a.numbers[i];
        difference.in_b = b.numbers[i];
        return difference;
    }
    return std::nullopt;
}

using Events = std::vector<Event>;
using Rows = std::vector<std::size_t>;  // indices of events

constexpr std::size_t kMostCandidates = 64;  // compared with an event that has no equal one

bool are_near(const Event& a, const Event& b, double tolerance) {
    return std::ranges::equal(a.numbers, b.numbers,
                              [&](const auto& x, const auto& y) { return are_near(x, y, tolerance); });
}

// Pairs the events of one step: each event of A gets its partner in B. Only events of equal kind and names are paired,
// first those with equal numbers, then those within the tolerance, then the others in the order of their numbers.
class EventPairs {
public:
    EventPairs(const Events& a, const Events& b, double tolerance)
        : a_(a), b_(b), partner_(a.size()), free_(b.size(), true) {
        const Rows rows_a = sorted(a), rows_b = sorted(b);
        pair_equal(rows_a, rows_b);
        if (tolerance > 0.0) pair_near(rows_a, rows_b, tolerance);
        pair_rest(rows_a, rows_b);
    }

    const Event* partner_of(std::size_t row_a) const { return partner_[row_a] ? &b_[*partner_[row_a]] : nullptr; }
    bool is_free(std::size_t row_b) const { return free_[row_b]; }

private:
    static auto key_of(const Event& event) { return std::tie(event.kind_and_names, event.numbers); }

    static Rows sorted(const Events& events) {
        Rows rows(events.size());
        std::iota(rows.begin(), rows.end(), std::size_t{0});
        std::ranges::sort(rows, {}, [&](std::size_t row) { return std::tuple(key_of(events[row]), row); });
        return rows;
    }

    void join(std::size_t row_a, std::size_t row_b) {
        partner_[row_a] = row_b;
        free_[row_b] = false;
    }

    void pair_equal(const Rows& rows_a, const Rows& rows_b) {
        for (std::size_t i = 0, j = 0; i < rows_a.size() && j < rows_b.size();) {
            const Event &in_a = a_[rows_a[i]], &in_b = b_[rows_b[j]];
            if (key_of(in_a) < key_of(in_b))
                ++i;
            else if (key_of(in_b) < key_of(in_a))
                ++j;
            else
                join(rows_a[i++], rows_b[j++]);
        }
    }

    // The free events of B with the kind and the names of this event of A, at most `count`.
    Rows candidates_of(const Event& event, const Rows& rows_b, std::size_t count) const {
        Rows found;
        auto row = std::ranges::partition_point(
            rows_b, [&](std::size_t index) { return b_[index].kind_and_names < event.kind_and_names; });
        for (; row != rows_b.end() && b_[*row].kind_and_names == event.kind_and_names && found.size() < count; ++row)
            if (free_[*row]) found.push_back(*row);
        return found;
    }

    void pair_near(const Rows& rows_a, Rows rows_b, double tolerance) {
        std::erase_if(rows_b, [&](std::size_t row) { return !free_[row]; });
        for (const std::size_t row : rows_a) {
            if (partner_[row]) continue;
            const Rows candidates = candidates_of(a_[row], rows_b, kMostCandidates);
            const auto near = std::ranges::find_if(
                candidates, [&](std::size_t in_b) { return are_near(a_[row], b_[in_b], tolerance); });
            if (near != candidates.end()) join(row, *near);
        }
    }

    void pair_rest(const Rows& rows_a, const Rows& rows_b) {
        for (std::size_t i = 0, j = 0; i < rows_a.size() && j < rows_b.size();) {
            const std::size_t row_a = rows_a[i], row_b = rows_b[j];
            if (partner_[row_a] || a_[row_a].kind_and_names < b_[row_b].kind_and_names)
                ++i;
            else if (!free_[row_b] || b_[row_b].kind_and_names < a_[row_a].kind_and_names)
                ++j;
            else
                join(rows_a[i++], rows_b[j++]);
        }
    }

    const Events& a_;
    const Events& b_;
    std::vector<std::optional<std::size_t>> partner_;  // [a.size()]: index into b
    std::vector<bool> free_;                           // [b.size()]: has no partner
};

void compare_step(const Events& a, const Events& b, double tolerance, EventComparison& comparison) {
    const auto keep_first = [&](const std::optional<EventDifference>& difference) {
        if (!comparison.first) comparison.first = difference;
    };
    const auto keep_alone = [&](const Event& event, const char* what) {
        EventDifference difference = difference_at(event);
        difference.what = what;
        keep_first(difference);
    };
    const EventPairs pairs(a, b, tolerance);
    for (std::size_t row = 0; row < a.size(); ++row) {
        const Event* const partner = pairs.partner_of(row);
        partner == nullptr ? ++comparison.only_a : ++comparison.common;
        if (partner == nullptr)
            keep_alone(a[row], "only A has it");
        else
            keep_first(compare_numbers(a[row], *partner, tolerance));
    }
    for (std::size_t row = 0; row < b.size(); ++row) {
        if (!pairs.is_free(row)) continue;
        ++comparison.only_b;
        keep_alone(b[row], "only B has it");
    }
}

}  // namespace

EventComparison compare_event_files(const std::filesystem::path& file_a, const std::filesystem::path& file_b,
                                    double tolerance) {
    EventFile a(file_a), b(file_b);
    EventComparison comparison;
    while (a.next() || b.next()) {
        const std::uint64_t step = !b.next()   ? a.next()->step
                                   : !a.next() ? b.next()->step
                                               : std::min(a.next()->step, b.next()->step);
        compare_step(a.take(step), b.take(step), tolerance, comparison);
    }
    return comparison;
}

std::string to_text(const EventComparison& comparison) {
    if (!comparison.first) return "equal: " + counted(comparison.common, "event") + "\n";
    const EventDifference& first = *comparison.first;
    std::string text = "the first difference is at step " + std::to_string(first.step) + " (";
    append_number(text, first.time);
    text += " s): " + first.event + " of '" + first.a + (first.b.empty() ? "'" : "' and '" + first.b + "'") + ": ";
    text +=
        first.what.empty() ? first.component + " is " + first.in_a + " in A and " + first.in_b + " in B" : first.what;
    return text + "\n  " + "events in both: " + std::to_string(comparison.common) + ", " +
           "only in A: " + std::to_string(comparison.only_a) + ", only in B: " + std::to_string(comparison.only_b) +
           "\n";
}

std::string to_json(const EventComparison& comparison) {
    JsonWriter json;
    json.open_object().member("equal", !comparison.first).member("common", comparison.common);
    json.member("only_a", comparison.only_a).member("only_b", comparison.only_b);
    if (comparison.first) {
        const EventDifference& first = *comparison.first;
        json.key("first").open_object().member("step", first.step).member("time", first.time);
        json.member("event", first.event).member("a", first.a).member("b", first.b);
        if (first.what.empty())
            json.member("component", first.component).member("in_a", first.in_a).member("in_b", first.in_b);
        else
            json.member("what", first.what);
        json.close_object();
    }
    return json.close_object().text() + "\n";
}

}  // namespace tumble::tools
