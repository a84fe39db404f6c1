#include "tools/health/health_report.hpp"

#include <algorithm>

#include "tools/output/step_stages.hpp"

namespace tumble::tools {

namespace {

void write_health_finding(JsonWriter& json, const ReportedFinding& reported) {
    const HealthFinding& finding = reported.finding;
    json.open_object()
        .member("check", finding.check)
        .member("subject", finding.subject)
        .member("text", finding.text)
        .member("remedy", finding.remedy)
        .member("step", finding.step)
        .member("time", finding.time)
        .member("bodies", reported.bodies);
    if (finding.point) json.member("point", *finding.point);
    json.member("value", finding.value)
        .member("limit", finding.limit)
        .member("unit", finding.unit)
        .member("more_of_a_kind", finding.more_of_a_kind)
        .close_object();
}

void write_slow_step(JsonWriter& json, const SlowStep& slow) {
    json.open_object().member("step", slow.step).key("ms").open_object();
    for (const StepStage& stage : kStepStages) json.member(stage.name, slow.counters.ms.*stage.ms);
    json.close_object().close_object();
}

}  // namespace

HealthReport make_health_report(const Scene& scene, const SceneWorld& built, const HealthWatch& watch) {
    HealthReport report{.scene_name = scene.name,
                        .steps = built.world.step_count(),
                        .time = built.world.time(),
                        .bodies = built.world.bodies().size(),
                        .findings = {},
                        .extremes = watch.extremes(),
                        .samples = watch.samples(),
                        .slow_steps = watch.slow_steps()};
    for (HealthFinding& finding : watch.findings()) {
        std::vector<std::string> names;
        for (const BodyId id : finding.bodies) {
            const auto body = std::ranges::find(built.bodies, id, &SceneInstance::id);
            names.push_back(output_name(*body, static_cast<std::size_t>(body - built.bodies.begin())));
        }
        report.findings.push_back({std::move(finding), std::move(names)});
    }
    return report;
}

void write_health(JsonWriter& json, const HealthReport& report) {
    json.open_object().key("findings").open_array();
    for (const ReportedFinding& reported : report.findings) write_health_finding(json, reported);
    json.close_array().key("extremes").open_array();
    for (const HealthExtreme& extreme : report.extremes)
        json.open_object()
            .member("quantity", extreme.quantity)
            .member("subject", extreme.subject)
            .member("value", extreme.value)
            .member("unit", extreme.unit)
            .member("step", extreme.step)
            .member("time", extreme.time)
            .member("point", extreme.point)
            .close_object();
    json.close_array().key("slow_steps").open_array();
    for (const SlowStep& slow : report.slow_steps) write_slow_step(json, slow);
    json.close_array().close_object();
}

}  // namespace tumble::tools
