#include "tools/diff/event_diff.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>
#include <vector>

#include "tools/output/csv_file.hpp"
#include "tools/output/json_writer.hpp"

namespace tumble::tools {

namespace {

constexpr std::array<std::string_view, 5> kNumbers{"x", "y", "nx", "ny", "speed"};

struct Event {
    std::uint64_t step = 0;
    double time = 0.0;
    std::array<std::string, 3> what;                   // event, a, b
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
        std::copy_n(fields.begin() + 2, next_->what.size(), next_->what.begin());
        std::copy_n(fields.begin() + 5, next_->numbers.size(), next_->numbers.begin());
    }

    CsvFile<10> csv_;
    std::optional<Event> next_;
};

std::optional<double> number_of(const std::string& text) {
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

bool are_near(const std::string& a, const std::string& b, double tolerance) {
    if (a == b) return true;
    const std::optional<double> x = number_of(a), y = number_of(b);
    return x && y && std::abs(*x - *y) <= tolerance;
}

EventDifference difference_at(const Event& event) {
    EventDifference difference;
    difference.step = event.step;
    difference.time = event.time;
    difference.event = event.what[0];
    difference.a = event.what[1];
    difference.b = event.what[2];
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

void compare_step(const std::vector<Event>& a, std::vector<Event> b, double tolerance, EventComparison& comparison) {
    const auto keep_first = [&](const std::optional<EventDifference>& difference) {
        if (!comparison.first) comparison.first = difference;
    };
    const auto keep_alone = [&](const Event& event, const char* what) {
        EventDifference difference = difference_at(event);
        difference.what = what;
        keep_first(difference);
    };
    for (const Event& event : a) {
        const auto found = std::ranges::find(b, event.what, &Event::what);
        if (found == b.end()) {
            ++comparison.only_a;
            keep_alone(event, "only A has it");
            continue;
        }
        ++comparison.common;
        keep_first(compare_numbers(event, *found, tolerance));
        b.erase(found);
    }
    comparison.only_b += b.size();
    for (const Event& event : b) keep_alone(event, "only B has it");
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
    if (!comparison.first) return "equal: " + std::to_string(comparison.common) + " events\n";
    const EventDifference& first = *comparison.first;
    std::string text = "the first difference is at step " + std::to_string(first.step) + " (";
    append_number(text, first.time);
    text += " s): " + first.event + " of '" + first.a + (first.b.empty() ? "'" : "' and '" + first.b + "'") + ": ";
    text +=
        first.what.empty() ? first.component + " is " + first.in_a + " in A and " + first.in_b + " in B" : first.what;
    return text + "\n  " + std::to_string(comparison.common) + " events are in both, " +
           std::to_string(comparison.only_a) + " only in A, " + std::to_string(comparison.only_b) + " only in B\n";
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
