#include "tools/shrink/failure.hpp"

#include <cctype>
#include <cstdlib>
#include <exception>

#include "tools/cli/error_report.hpp"
#include "tumble/world.hpp"

namespace tumble::tools {

namespace {

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

// The end of the number that begins at `begin`: digits, a fraction, an exponent.
std::size_t end_of_number(std::string_view text, std::size_t begin) {
    const auto skip_digits = [&](std::size_t at) {
        while (at < text.size() && is_digit(text[at])) ++at;
        return at;
    };
    std::size_t end = skip_digits(begin);
    if (end + 1 < text.size() && text[end] == '.' && is_digit(text[end + 1])) end = skip_digits(end + 1);
    if (end < text.size() && text[end] == 'e') {
        const std::size_t sign = end + 1 < text.size() && (text[end + 1] == '-' || text[end + 1] == '+') ? 1 : 0;
        const std::size_t exponent = end + 1 + sign;
        if (exponent < text.size() && is_digit(text[exponent])) end = skip_digits(exponent);
    }
    return end;
}

std::string interval_side(const SceneInterval& allowed, double value) {
    if (value < allowed.lower) return ", below";
    return value > allowed.upper ? ", above" : "";
}

std::string box_side(const SceneBox& box, double x, double y) {
    const double sides[] = {box.first.x - x, x - box.second.x, box.first.y - y, y - box.second.y};
    const char* const names[] = {", on the left", ", on the right", ", below", ", above"};
    std::size_t farthest = 0;
    for (std::size_t i = 1; i < 4; ++i)
        if (sides[i] > sides[farthest]) farthest = i;
    return sides[farthest] > 0.0 ? names[farthest] : "";
}

// Up to two numbers, apart by ", ", after the last occurrence of the words.
std::vector<double> numbers_after(const std::string& text, std::string_view words) {
    std::vector<double> numbers;
    std::size_t at = text.rfind(words);
    if (at == std::string::npos) return numbers;
    for (at += words.size(); numbers.size() < 2; at += 2) {
        const char* const begin = text.c_str() + at;
        char* end = nullptr;
        const double number = std::strtod(begin, &end);
        if (end == begin) break;
        numbers.push_back(number);
        at += static_cast<std::size_t>(end - begin);
        if (text.compare(at, 2, ", ") != 0) break;
    }
    return numbers;
}

bool counts(const SceneExpectation& claim, const ExpectationResult& result) {
    return result.is_decided && !result.passed && claim.state_hash.empty() && !claim.max_ms_per_step;
}

Failure failure_of(const SceneExpectation& claim, const ExpectationResult& result, std::size_t index, bool any_body) {
    const std::string finding = any_body ? with_masked_names(result.finding) : result.finding;
    return {result.claim + ": " + with_masked_numbers(finding) + side_of(claim, result.finding), result.step,
            static_cast<int>(index)};
}

std::vector<ExpectationResult> results_of(const Scene& scene) {
    SceneRun run(scene);
    ExpectationWatch watch(scene, run.built());
    watch.observe(run.built());
    const std::uint64_t step_count = count_steps(scene);
    for (std::uint64_t step = 0; step < step_count && !run.is_stopped(); ++step) {
        run.step();
        watch.observe(run.built());
    }
    return watch.results();
}

Failure failure_of(const std::exception_ptr& exception) {
    Failure failure{with_masked_numbers(explain(exception).message)};
    try {
        std::rethrow_exception(exception);
    } catch (const SimulationDiverged& diverged) {
        failure.step = diverged.step;
    } catch (...) {  // at a step that is not known
    }
    return failure;
}

}  // namespace

std::string with_masked_numbers(std::string_view text) {
    std::string masked;
    for (std::size_t at = 0; at < text.size();) {
        const bool is_inside_word = at > 0 && is_word(text[at - 1]);
        if (is_inside_word || !is_digit(text[at])) {
            masked += text[at++];
            continue;
        }
        if (masked.ends_with('-')) masked.pop_back();
        masked += '#';
        at = end_of_number(text, at);
    }
    return masked;
}

std::string with_masked_names(std::string_view text) {
    std::string masked;
    bool is_inside = false;
    for (const char c : text) {
        if (c == '\'')
            masked += is_inside ? "*'" : "'";
        else if (!is_inside)
            masked += c;
        is_inside ^= c == '\'';
    }
    return masked;
}

std::string side_of(const SceneExpectation& claim, const std::string& finding) {
    if (claim.inside) {
        const std::vector<double> point = numbers_after(finding, "it is at [");
        return point.size() < 2 ? "" : box_side(*claim.inside, point[0], point[1]);
    }
    const SceneInterval* allowed = nullptr;
    for (const auto* interval : {&claim.height, &claim.speed, &claim.angle, &claim.count, &claim.event_count})
        if (*interval) allowed = &**interval;
    for (const char* words : {" is ", "there are ", "there were "})
        if (const std::vector<double> values = numbers_after(finding, words); allowed && !values.empty())
            return interval_side(*allowed, values[0]);
    return "";
}

std::vector<Failure> find_failures(const Scene& scene, bool any_body) {
    try {
        const std::vector<ExpectationResult> results = results_of(scene);
        std::vector<Failure> failures;
        for (std::size_t i = 0; i < results.size(); ++i)
            if (counts(scene.expect[i], results[i]))
                failures.push_back(failure_of(scene.expect[i], results[i], i, any_body));
        return failures;
    } catch (...) {
        return {failure_of(std::current_exception())};
    }
}

ExpectationResult result_of_claim(const Scene& scene, int claim) {
    return results_of(scene).at(static_cast<std::size_t>(claim));
}

}  // namespace tumble::tools
