#include "tools/health/health_page.hpp"

#include <algorithm>
#include <cctype>

#include "tools/health/health_plots.hpp"
#include "tools/output/html.hpp"
#include "tools/output/number_text.hpp"
#include "tools/output/step_stages.hpp"

namespace tumble::tools {

namespace {

std::string moment_of(std::uint64_t step, double time) {
    return four_digits(time) + " s, step " + std::to_string(step);
}

std::string value_with_unit(double value, const std::string& unit) {
    return four_digits(value) + (unit.empty() ? "" : " " + unit);
}

std::string_view check_title(const HealthFinding& finding) {
    return std::ranges::find(kHealthChecks, finding.check, &HealthCheckName::name)->title;
}

std::string as_sentence(std::string text) {
    text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
    return text + ".";
}

HtmlCell value_cell(const std::string& text) { return {.text = text, .is_number = true}; }

void add_overview(HtmlPage& page, const HealthReport& report) {
    page.paragraph(report.scene_name + ": " + counted(report.bodies, "body") + " at the end, " +
                   counted(report.steps, "step") + ", " + four_digits(report.time) + " s.");
    if (!report.note.empty()) page.paragraph(report.note);
    if (report.findings.empty()) return page.paragraph("No check has found a fault.");
    const std::vector<std::string> header{"finding", "bodies or joint", "when", "value", "limit"};
    std::vector<std::vector<HtmlCell>> rows;
    for (const ReportedFinding& reported : report.findings) {
        const HealthFinding& finding = reported.finding;
        const std::string more = finding.more_of_a_kind ? ", " + std::to_string(finding.more_of_a_kind) + " more" : "";
        rows.push_back({{.text = std::string(check_title(finding)), .is_alarm = true},
                        {.text = finding.subject + more},
                        {.text = moment_of(finding.step, finding.time)},
                        value_cell(value_with_unit(finding.value, finding.unit)),
                        value_cell(finding.limit > 0.0 ? value_with_unit(finding.limit, finding.unit) : "")});
    }
    page.table(header, rows);
}

void add_health_findings(HtmlPage& page, const HealthReport& report) {
    if (!report.picture_error.empty()) page.paragraph("Pictures are missing: " + report.picture_error);
    for (const ReportedFinding& reported : report.findings) {
        const HealthFinding& finding = reported.finding;
        page.heading(std::string(check_title(finding)) + ": " + finding.subject);
        std::string text = as_sentence(finding.text);
        if (finding.more_of_a_kind > 0)
            text += " The same holds for " + std::to_string(finding.more_of_a_kind) + " more of its kind.";
        page.paragraph(text);
        page.paragraph("Remedy: " + finding.remedy);
        if (reported.picture) page.picture(*reported.picture, moment_of(finding.step, finding.time));
    }
}

void add_course(HtmlPage& page, const HealthReport& report) {
    page.heading("The run");
    page.begin_figures();
    for (const Plot& plot : health_plots(report.samples)) page.figure(plot);
    page.end_figures();
    const std::vector<std::string> header{"largest", "value", "bodies or joint", "when", "x, m", "y, m"};
    std::vector<std::vector<HtmlCell>> rows;
    for (const HealthExtreme& extreme : report.extremes)
        rows.push_back({{.text = extreme.quantity},
                        value_cell(value_with_unit(extreme.value, extreme.unit)),
                        {.text = extreme.subject},
                        {.text = moment_of(extreme.step, extreme.time)},
                        value_cell(four_digits(extreme.point.x)),
                        value_cell(four_digits(extreme.point.y))});
    page.table(header, rows);
}

void add_slow_steps(HtmlPage& page, const HealthReport& report) {
    page.heading("The slowest steps");
    page.paragraph("Wall clock in ms, of each stage and of the whole step. Steps of few bodies have the latter alone.");
    std::vector<std::string> header{"number"};
    for (const StepStage& stage : kStepStages) header.emplace_back(stage.name);
    header.insert(header.end(), {"awake bodies", "contacts"});
    std::vector<std::vector<HtmlCell>> rows;
    for (const SlowStep& slow : report.slow_steps) {
        std::vector<HtmlCell> row{value_cell(std::to_string(slow.step))};
        for (const StepStage& stage : kStepStages) row.push_back(value_cell(four_digits(slow.counters.ms.*stage.ms)));
        row.push_back(value_cell(std::to_string(slow.counters.awake_bodies)));
        row.push_back(value_cell(std::to_string(slow.counters.contacts)));
        rows.push_back(std::move(row));
    }
    page.table(header, rows);
}

void add_checks(HtmlPage& page, const HealthReport& report) {
    page.heading("The checks");
    const std::vector<std::string> header{"check", "findings", "there is a finding if"};
    std::vector<std::vector<HtmlCell>> rows;
    for (const HealthCheckName& check : kHealthChecks) {
        const auto count = std::ranges::count_if(
            report.findings, [&](const ReportedFinding& reported) { return reported.finding.check == check.name; });
        rows.push_back({{.text = std::string(check.title)},
                        {.text = count ? std::to_string(count) : "none", .is_alarm = count > 0, .is_good = count == 0},
                        {.text = std::string(check.rule)}});
    }
    page.table(header, rows);
}

}  // namespace

std::string health_page(const HealthReport& report) {
    HtmlPage page("Health of " + report.scene_name);
    add_overview(page, report);
    add_health_findings(page, report);
    add_course(page, report);
    if (!report.slow_steps.empty()) add_slow_steps(page, report);
    add_checks(page, report);
    return page.str();
}

}  // namespace tumble::tools
